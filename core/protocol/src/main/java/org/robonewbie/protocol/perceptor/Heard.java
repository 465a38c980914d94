package org.robonewbie.protocol.perceptor;

import java.util.Optional;
import java.util.OptionalDouble;

/**
 * A message said by a robot: perceptor {@code hear}.
 *
 * @param team the speaker's team; old servers do not send it
 * @param playSeconds game time in seconds at which it was heard
 * @param directionDegrees direction of the speaker in the team's own view of the field, not relative to the robot: 0 is towards
 *     the opponents' goal, positive is left; empty for the robot's own message
 * @param text what was said, up to 20 characters without blanks
 */
public record Heard(Optional<String> team, double playSeconds, OptionalDouble directionDegrees, String text) {

    /** {@return whether this is the robot's own message} */
    public boolean isOwn() {
        return directionDegrees.isEmpty();
    }
}
