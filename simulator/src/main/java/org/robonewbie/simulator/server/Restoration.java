package org.robonewbie.simulator.server;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.robonewbie.nao.Vector3;
import org.robonewbie.simulator.RobotSnapshot;
import org.robonewbie.simulator.WorldSnapshot;
import org.robonewbie.simulator.physics.Pose;
import org.robonewbie.simulator.physics.Rotation;
import org.robonewbie.simulator.soccer.Player;
import org.robonewbie.simulator.soccer.TrainersHand;
import org.robonewbie.simulator.world.LinkMotion;

/** Puts a world into a state that was seen before; velocities are those between two states. */
final class Restoration {

    private static final int NUMBERS_PER_LINK = 7;

    private final SimulationCycle cycle;

    Restoration(SimulationCycle cycle) {
        this.cycle = cycle;
    }

    void restore(WorldSnapshot before, WorldSnapshot moment) {
        double seconds = moment.seconds() - before.seconds();
        restoreGame(moment);
        for (RobotSnapshot robot : moment.robots()) {
            RobotSnapshot earlier = before.robots().stream()
                    .filter(each -> each.id() == robot.id() && each.type() == robot.type())
                    .findFirst()
                    .orElse(robot);
            player(robot).ifPresent(player -> player.robot().place(motions(earlier, robot, seconds)));
        }
        cycle.world().ball().place(LinkMotion.between(ball(before), ball(moment), seconds));
    }

    private void restoreGame(WorldSnapshot moment) {
        TrainersHand hand = new TrainersHand(cycle.match());
        if (moment.playMode() != cycle.match().state().playMode()) {
            cycle.match().setPlayMode(moment.playMode());
        }
        hand.setHalf(moment.half());
        hand.setPlaySeconds(moment.gameTime());
        hand.setScore(moment.scoreLeft(), moment.scoreRight());
    }

    private Optional<Player> player(RobotSnapshot robot) {
        return robot.side()
                .flatMap(side -> cycle.match().teams().player(side, robot.number()))
                .filter(player -> player.robot().model().type() == robot.type());
    }

    private static List<LinkMotion> motions(RobotSnapshot before, RobotSnapshot now, double seconds) {
        List<LinkMotion> motions = new ArrayList<>();
        for (int i = 0; i < now.linkPoses().length; i += NUMBERS_PER_LINK) {
            motions.add(LinkMotion.between(pose(before.linkPoses(), i), pose(now.linkPoses(), i), seconds));
        }
        return motions;
    }

    private static Pose ball(WorldSnapshot snapshot) {
        float[] turn = snapshot.ballOrientation();
        return new Pose(snapshot.ballPosition(), Rotation.ofQuaternion(turn[0], turn[1], turn[2], turn[3]));
    }

    private static Pose pose(float[] numbers, int at) {
        return new Pose(
                new Vector3(numbers[at], numbers[at + 1], numbers[at + 2]),
                Rotation.ofQuaternion(numbers[at + 3], numbers[at + 4], numbers[at + 5], numbers[at + 6]));
    }
}
