package org.robonewbie.simulator.physics.sparse;

/** ODE settings that SimSpark changes ({@code odeworld.cpp}, {@code spark.rb}); all others are ODE's defaults. */
final class PhysicsConstants {

    /** Fraction of a joint error that one step corrects (ODE: ERP). */
    static final double ERROR_REDUCTION = 0.2;

    /** Default constraint force mixing of a row (ODE: CFM). */
    static final double SOFTNESS = 1e-5;

    /** Penetration depth, in metres, up to which no correction is applied. */
    static final double CONTACT_SURFACE_LAYER = 0.001;

    private PhysicsConstants() {}
}
