package org.robonewbie.simulator.physics.ode;

import org.ode4j.ode.DContact.DSurfaceParameters;
import org.ode4j.ode.OdeConstants;
import org.robonewbie.simulator.physics.Material;

/** Writes a material in ODE's words. */
final class OdeSurface {

    private OdeSurface() {}

    static void describe(Material material, double grip, DSurfaceParameters parameters) {
        parameters.mode = 0;
        parameters.mu = OdeConstants.dInfinity;
        material.bounce().ifPresent(bounce -> {
            parameters.mode |= OdeConstants.dContactBounce;
            parameters.bounce = bounce.restitution();
            parameters.bounce_vel = bounce.minimumVelocity();
        });
        material.errorReduction().ifPresent(value -> {
            parameters.mode |= OdeConstants.dContactSoftERP;
            parameters.soft_erp = value;
        });
        material.softness().ifPresent(value -> {
            parameters.mode |= OdeConstants.dContactSoftCFM;
            parameters.soft_cfm = value;
        });
        material.slip().ifPresent(value -> {
            parameters.mode |= OdeConstants.dContactSlip1 | OdeConstants.dContactSlip2;
            parameters.slip1 = value / grip;
            parameters.slip2 = value / grip;
        });
    }
}
