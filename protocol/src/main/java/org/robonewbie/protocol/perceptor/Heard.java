package org.robonewbie.protocol.perceptor;

import java.util.Optional;
import java.util.OptionalDouble;

/**
 * A message that a robot said: perceptor {@code hear}.
 *
 * @param team the speaker's team; old servers do not send it
 * @param playSeconds time of play in seconds at which it was heard
 * @param directionDegrees where the speaker stands as seen in the own team's view of the field, not relative to the robot: 0
 *     is towards the opponents' goal, positive is left; empty for the robot's own message
 * @param text what was said, up to 20 characters without blanks
 */
public record Heard(Optional<String> team, double playSeconds, OptionalDouble directionDegrees, String text) {

    /**
     * Tells whether this is the robot's own message.
     *
     * @return true if the robot hears itself
     */
    public boolean isOwn() {
        return directionDegrees.isEmpty();
    }
}
