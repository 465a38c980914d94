package org.robonewbie.simulator.physics.sparse;

import java.util.Optional;
import java.util.OptionalDouble;
import org.robonewbie.simulator.physics.Material;

/**
 * Contact parameters of a pair of materials; the engine's default where neither material specifies a value.
 *
 * @param errorReduction fraction of a penetration that one step corrects (ODE: ERP)
 * @param softness constraint force mixing along the normal (ODE: CFM)
 * @param slip tangential speed in metres per second per newton (ODE: force-dependent slip)
 * @param restitution coefficient of restitution; negative if the contact does not bounce
 * @param minimumVelocity minimum approach speed in metres per second for a bounce
 */
record ContactSurface(double errorReduction, double softness, double slip, double restitution, double minimumVelocity) {

    /** Contact surface between two materials that specify no values. */
    static final ContactSurface HARD = of(
            new Material(Optional.empty(), OptionalDouble.empty(), OptionalDouble.empty(), OptionalDouble.empty()), 1);

    static ContactSurface of(Material material, double grip) {
        return new ContactSurface(
                material.errorReduction().orElse(PhysicsConstants.ERROR_REDUCTION),
                material.softness().orElse(PhysicsConstants.SOFTNESS),
                material.slip().orElse(PhysicsConstants.SOFTNESS) / grip,
                material.bounce().map(Material.Bounce::restitution).orElse(-1.0),
                material.bounce().map(Material.Bounce::minimumVelocity).orElse(0.0));
    }

    boolean bounces() {
        return restitution >= 0;
    }

    /** Returns the separation speed after an impact with the given approach speed; 0 if there is no bounce. */
    double reboundSpeed(double approach) {
        return bounces() && approach > minimumVelocity ? restitution * approach : 0;
    }
}
