package org.robonewbie.simulator.physics;

import org.robonewbie.nao.Vector3;

/**
 * Parameters of a hinge with a motor and two soft stops.
 *
 * @param anchor a point on the axis in the world frame, metres
 * @param axis direction of the axis in the world frame, unit length
 * @param minRadians angle of the lower stop in radians
 * @param maxRadians angle of the upper stop in radians
 * @param maxTorque maximum motor torque in newton metres
 * @param stopBounce coefficient of restitution of the stops
 */
public record HingeDefinition(
        Vector3 anchor, Vector3 axis, double minRadians, double maxRadians, double maxTorque, double stopBounce) {

    /** Constraint force mixing of hinge and stops (ODE: CFM). */
    public static final double SOFTNESS = 1e-8;

    /** Fraction of an overshoot at a stop that is corrected per step (ODE: stop ERP). */
    public static final double STOP_ERROR_REDUCTION = 0.8;

    /**
     * Factor applied to a motor torque that points away from the stop reached by the hinge (ODE: fudge factor).
     */
    public static final double FUDGE_FACTOR = 1e-5;
}
