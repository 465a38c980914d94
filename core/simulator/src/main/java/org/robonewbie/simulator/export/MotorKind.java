package org.robonewbie.simulator.export;

/** What the numbers mean that a controller gives to the motors of an exported robot. */
public enum MotorKind {
    /** Target speeds in radians per second, as in SimSpark. */
    SPEED,
    /** Target angles in radians. */
    POSITION,
    /** Torques in newton metres. */
    TORQUE
}
