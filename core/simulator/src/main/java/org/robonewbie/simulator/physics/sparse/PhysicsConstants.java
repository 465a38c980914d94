package org.robonewbie.simulator.physics.sparse;

/** SimSpark's settings of ODE ({@code odeworld.cpp}, {@code spark.rb}); what it leaves alone has ODE's default. */
final class PhysicsConstants {

    /** Share of a gap that one step closes (ODE: ERP). */
    static final double ERROR_REDUCTION = 0.2;

    /** How soft a row is that says nothing else (ODE: CFM). */
    static final double SOFTNESS = 1e-5;

    /** Depth in metres to which a contact may sink before it is pushed out. */
    static final double CONTACT_SURFACE_LAYER = 0.001;

    private PhysicsConstants() {}
}
