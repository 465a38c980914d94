package org.robonewbie.agent.perception;

import java.util.Optional;
import java.util.OptionalDouble;

/**
 * A message from another robot.
 *
 * @param text 1 to 20 characters
 * @param team name of the speaker's team; empty if the server is too old to send it
 * @param directionDegrees direction of the speaker in the frame of the field, not relative to the robot: 0 is towards the
 *     opponents' goal, positive is left
 */
public record HeardMessage(String text, Optional<String> team, OptionalDouble directionDegrees) {}
