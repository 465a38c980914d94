package org.robonewbie.simulator.recording;

import java.util.List;
import java.util.Optional;
import org.robonewbie.protocol.effector.EffectorCommand;
import org.robonewbie.simulator.soccer.Player;
import org.robonewbie.simulator.world.Robot;

/**
 * A robot in one cycle of a run.
 *
 * @param id id of the robot
 * @param player the player; empty before it joins a team
 * @param robot the body
 * @param commands the agent's commands that are executed in this cycle
 * @param unansweredMessages number of messages so far to which the agent did not respond in time
 */
public record Participant(
        int id, Optional<Player> player, Robot robot, List<EffectorCommand> commands, long unansweredMessages) {}
