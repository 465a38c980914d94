package org.robonewbie.simulator.physics;

import java.util.Optional;
import java.util.OptionalDouble;

/**
 * Contact properties of a surface. Friction is unlimited, but the surface slips under load.
 *
 * <p>If a value is empty, the other surface's value applies; if both are empty, the engine's default applies. Source:
 * SimSpark's contact joint handler and ODE's contact parameters.
 *
 * @param bounce restitution
 * @param errorReduction fraction of a penetration that is corrected per step (ODE: soft ERP)
 * @param softness constraint force mixing of the contact (ODE: soft CFM)
 * @param slip slip speed in metres per second per newton of tangential force (ODE: slip1, slip2)
 */
public record Material(
        Optional<Bounce> bounce, OptionalDouble errorReduction, OptionalDouble softness, OptionalDouble slip) {

    /**
     * Restitution of a surface.
     *
     * @param restitution coefficient of restitution, 0 to 1
     * @param minimumVelocity minimum approach speed in metres per second for a bounce
     */
    public record Bounce(double restitution, double minimumVelocity) {}

    /**
     * Combines two surfaces: each property is the mean of both values, or the only value if just one surface specifies
     * it.
     *
     * @param other the other surface
     * @return the properties of their contact
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
