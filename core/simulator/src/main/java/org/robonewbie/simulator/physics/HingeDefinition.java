package org.robonewbie.simulator.physics;

import org.robonewbie.nao.Vector3;

/**
 * A hinge with a motor and two soft stops.
 *
 * @param anchor a point on the axis in the world frame, metres
 * @param axis direction of the axis in the world frame, length 1
 * @param minRadians lower stop
 * @param maxRadians upper stop
 * @param maxTorque strength of the motor in newton metres
 * @param softness constraint force mixing (ODE: CFM) of hinge and stops
 * @param stopErrorReduction share of an overshoot at a stop that is corrected per step (ODE: stop ERP)
 * @param stopBounce share of the speed that a stop gives back
 * @param fudgeFactor ODE's factor against jumps when the motor leaves a stop
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
