package org.robonewbie.simulator.physics;

import org.robonewbie.nao.Vector3;

/**
 * Parameters of a hinge with a motor and two soft stops.
 *
 * @param anchor a point on the axis in the world frame, metres
 * @param axis direction of the axis in the world frame, unit length
 * @param minRadians lower stop
 * @param maxRadians upper stop
 * @param maxTorque maximum motor torque in newton metres
 * @param softness constraint force mixing of hinge and stops (ODE: CFM)
 * @param stopErrorReduction fraction of an overshoot at a stop that is corrected per step (ODE: stop ERP)
 * @param stopBounce coefficient of restitution of the stops
 * @param fudgeFactor ODE's factor that reduces the motor torque away from a stop
 */
public record HingeDefinition(
        Vector3 anchor,
        Vector3 axis,
        double minRadians,
        double maxRadians,
        double maxTorque,
        double softness,
        double stopErrorReduction,
        double stopBounce,
        double fudgeFactor) {}
