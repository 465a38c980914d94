package org.robonewbie.protocol.perceptor;

import java.util.Optional;
import java.util.OptionalDouble;

/**
 * A received voice message: perceptor {@code hear}.
 *
 * @param team the speaker's team; not sent by old servers
 * @param playSeconds game time at which the message was received, in seconds
 * @param directionDegrees direction of the speaker in the team's frame, not relative to the robot: 0 towards the opponents' goal,
 *     positive to the left; empty for the robot's own message
 * @param text the text, up to 20 characters without spaces
 */
public record Heard(Optional<String> team, double playSeconds, OptionalDouble directionDegrees, String text) {

    /** {@return whether this is the robot's own message} */
    public boolean isOwn() {
        return directionDegrees.isEmpty();
    }
}
