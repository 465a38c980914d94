package org.robonewbie.simulator.recording;

import java.util.List;
import java.util.Optional;
import org.robonewbie.protocol.effector.EffectorCommand;
import org.robonewbie.simulator.soccer.Player;
import org.robonewbie.simulator.world.Robot;

/**
 * A robot in one cycle of a run.
 *
 * @param id number of its agent's connection
 * @param player its place in a team, empty before it has one
 * @param robot its body
 * @param commands what its agent commanded in this cycle
 * @param unansweredMessages messages so far to which the agent's answer came too late
 */
public record Participant(
        int id, Optional<Player> player, Robot robot, List<EffectorCommand> commands, long unansweredMessages) {}
