package org.robonewbie.protocol.perceptor;

import java.util.Optional;

/**
 * The contact forces on the feet; empty for a foot without contact.
 *
 * @param left the left foot, {@code lf}
 * @param right the right foot, {@code rf}
 * @param leftToe the left toe of robot type 4, {@code lf1}
 * @param rightToe the right toe of robot type 4, {@code rf1}
 */
public record FootForces(
        Optional<FootForce> left,
        Optional<FootForce> right,
        Optional<FootForce> leftToe,
        Optional<FootForce> rightToe) {

    /** No contact forces, as for a robot in the air. */
    public static final FootForces NONE = of(Optional.empty(), Optional.empty());

    /**
     * Creates the foot forces for a robot without toes.
     *
     * @param left the left foot
     * @param right the right foot
     * @return the forces
     */
    public static FootForces of(Optional<FootForce> left, Optional<FootForce> right) {
        return new FootForces(left, right, Optional.empty(), Optional.empty());
    }
}
