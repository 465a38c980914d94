package org.robonewbie.agent.perception;

import java.util.Optional;
import java.util.OptionalDouble;

/**
 * What another robot has said.
 *
 * @param text 1 to 20 characters
 * @param team name of the speaker's team; old servers do not tell it
 * @param directionDegrees where the speaker stands, in the pitch's frame and not relative to the robot: 0 is towards the opponents'
 *     goal, positive is left
 */
public record HeardMessage(String text, Optional<String> team, OptionalDouble directionDegrees) {}
