package org.robonewbie.simulator.physics.sparse;

import java.util.Optional;
import java.util.OptionalDouble;
import org.robonewbie.simulator.physics.Material;

/**
 * How two materials behave in contact, with the engine's default where both leave a matter open.
 *
 * @param errorReduction share of a penetration that one step pushes out
 * @param softness how much the normal gives way
 * @param slip metres per second of slip per newton
 * @param restitution share of the speed that is thrown back; negative if the contact does not bounce
 * @param minimumVelocity slowest approach in metres per second that bounces
 */
record ContactSurface(double errorReduction, double softness, double slip, double restitution, double minimumVelocity) {

    /** How surfaces behave that leave every matter open. */
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

    /** The speed at which something leaves that came with a given speed; 0 if it does not bounce. */
    double thrownBack(double approach) {
        return bounces() && approach > minimumVelocity ? restitution * approach : 0;
    }
}
