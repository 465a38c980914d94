package org.robonewbie.simulator.server;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.robonewbie.nao.TeamSide;
import org.robonewbie.simulator.RobotSnapshot;
import org.robonewbie.simulator.WorldSnapshot;
import org.robonewbie.simulator.physics.Pose;
import org.robonewbie.simulator.physics.Rotation;
import org.robonewbie.simulator.soccer.GameState;
import org.robonewbie.simulator.soccer.Match;
import org.robonewbie.simulator.soccer.Player;
import org.robonewbie.simulator.world.Robot;

/** Takes pictures of the world for observers. */
final class Snapshots {

    private static final int NUMBERS_PER_LINK = 7;

    private Snapshots() {}

    static WorldSnapshot of(SimulationCycle cycle, boolean paused, Pacemaker pacemaker) {
        return of(cycle, paused, pacemaker.speed(), pacemaker.realTimeFactor());
    }

    static WorldSnapshot of(SimulationCycle cycle, boolean paused, double speed, double realTimeFactor) {
        Match match = cycle.match();
        GameState state = match.state();
        List<RobotSnapshot> robots = new ArrayList<>();
        for (ConnectedAgent agent : cycle.agents()) {
            agent.robot().ifPresent(robot -> robots.add(robot(agent, robot)));
        }
        return new WorldSnapshot(
                cycle.cycle(),
                state.playSeconds(),
                state.playMode(),
                match.teams().name(TeamSide.LEFT),
                match.teams().name(TeamSide.RIGHT),
                state.score(TeamSide.LEFT),
                state.score(TeamSide.RIGHT),
                state.half(),
                cycle.world().ball().position(),
                quaternion(cycle.world().ball().rotation()),
                robots,
                paused,
                speed,
                realTimeFactor);
    }

    private static RobotSnapshot robot(ConnectedAgent agent, Robot robot) {
        Optional<Player> player = agent.player();
        return new RobotSnapshot(
                agent.id(),
                player.map(member -> member.team().name()).orElse(""),
                player.map(Player::side),
                player.map(Player::number).orElse(0),
                robot.model().type(),
                linkPoses(robot),
                jointDegrees(robot));
    }

    private static float[] linkPoses(Robot robot) {
        int count = robot.model().links().size();
        float[] poses = new float[NUMBERS_PER_LINK * count];
        for (int i = 0; i < count; i++) {
            Pose pose = robot.linkPose(i);
            poses[NUMBERS_PER_LINK * i] = (float) pose.position().x();
            poses[NUMBERS_PER_LINK * i + 1] = (float) pose.position().y();
            poses[NUMBERS_PER_LINK * i + 2] = (float) pose.position().z();
            System.arraycopy(quaternion(pose.rotation()), 0, poses, NUMBERS_PER_LINK * i + 3, 4);
        }
        return poses;
    }

    private static float[] jointDegrees(Robot robot) {
        float[] degrees = new float[robot.model().hinges().size()];
        for (int i = 0; i < degrees.length; i++) {
            degrees[i] = (float) robot.jointDegrees(i);
        }
        return degrees;
    }

    private static float[] quaternion(Rotation rotation) {
        double[] exact = rotation.toQuaternion();
        return new float[] {(float) exact[0], (float) exact[1], (float) exact[2], (float) exact[3]};
    }
}
