package org.robonewbie.simulator.physics;

import java.util.Optional;
import java.util.OptionalDouble;

/**
 * How a surface behaves in contact; friction is unlimited, and slip makes it give way.
 *
 * <p>An empty value means that the surface leaves the matter to the other side; when both do, the engine's default
 * holds. Source: SimSpark's contact joint handler on top of ODE's contact parameters.
 *
 * @param bounce how it bounces
 * @param errorReduction share of a penetration that is corrected per step (ODE: soft ERP)
 * @param softness constraint force mixing of the contact (ODE: soft CFM)
 * @param slip velocity in metres per second by which the contact slips per newton of tangential force (ODE: slip1, slip2)
 */
public record Material(
        Optional<Bounce> bounce, OptionalDouble errorReduction, OptionalDouble softness, OptionalDouble slip) {

    /**
     * How a surface throws back.
     *
     * @param restitution share of the speed that is given back, 0 to 1
     * @param minimumVelocity slowest approach in metres per second that bounces at all
     */
    public record Bounce(double restitution, double minimumVelocity) {}

    /**
     * Mixes two surfaces: a value that only one side has is taken, of two values the mean.
     *
     * @param other the other side
     * @return how both behave in contact
     */
    public Material mixedWith(Material other) {
        return new Material(
                mixed(bounce, other.bounce),
                mixed(errorReduction, other.errorReduction),
                mixed(softness, other.softness),
                mixed(slip, other.slip));
    }

    private static Optional<Bounce> mixed(Optional<Bounce> one, Optional<Bounce> two) {
        if (one.isEmpty() || two.isEmpty()) {
            return one.isPresent() ? one : two;
        }
        return Optional.of(new Bounce(
                (one.get().restitution() + two.get().restitution()) / 2,
                (one.get().minimumVelocity() + two.get().minimumVelocity()) / 2));
    }

    private static OptionalDouble mixed(OptionalDouble one, OptionalDouble two) {
        if (one.isEmpty() || two.isEmpty()) {
            return one.isPresent() ? one : two;
        }
        return OptionalDouble.of((one.getAsDouble() + two.getAsDouble()) / 2);
    }
}
