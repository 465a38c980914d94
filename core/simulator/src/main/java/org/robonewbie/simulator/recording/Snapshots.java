package org.robonewbie.simulator.recording;

import java.util.List;
import java.util.Optional;
import org.robonewbie.nao.TeamSide;
import org.robonewbie.simulator.RobotSnapshot;
import org.robonewbie.simulator.WorldSnapshot;
import org.robonewbie.simulator.soccer.Match;
import org.robonewbie.simulator.soccer.MatchState;
import org.robonewbie.simulator.soccer.Player;
import org.robonewbie.simulator.world.SoccerWorld;

/** Creates snapshots of the world for recordings and observers. */
public final class Snapshots {

    private Snapshots() {}

    /**
     * Takes a snapshot with the clock values of a real-time simulation.
     *
     * @param cycle number of the cycle
     * @param match the game
     * @param world the world with the ball and other objects
     * @param participants all robots in the order in which they connected
     * @return the current state
     */
    public static WorldSnapshot of(long cycle, Match match, SoccerWorld world, List<Participant> participants) {
        MatchState state = match.state();
        return new WorldSnapshot(
                cycle,
                state.playSeconds(),
                state.playMode(),
                match.teams().name(TeamSide.LEFT),
                match.teams().name(TeamSide.RIGHT),
                state.score(TeamSide.LEFT),
                state.score(TeamSide.RIGHT),
                state.half(),
                world.ball().position(),
                world.ball().rotation().toQuaternion(),
                robots(participants),
                world.things().now(),
                false,
                1,
                1);
    }

    private static List<RobotSnapshot> robots(List<Participant> participants) {
        RobotSnapshot[] robots = new RobotSnapshot[participants.size()];
        for (int i = 0; i < robots.length; i++) {
            robots[i] = robot(participants.get(i));
        }
        return List.of(robots);
    }

    private static RobotSnapshot robot(Participant participant) {
        Optional<Player> player = participant.player();
        return new RobotSnapshot(
                participant.id(),
                player.isPresent() ? player.get().team().name() : "",
                player.map(Player::side),
                player.isPresent() ? player.get().number() : 0,
                participant.robot().state());
    }
}
