package org.robonewbie.simulator.cycle;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.robonewbie.simulator.RobotSnapshot;
import org.robonewbie.simulator.WorldSnapshot;
import org.robonewbie.simulator.landscape.Thing;
import org.robonewbie.simulator.physics.BodyPose;
import org.robonewbie.simulator.physics.RotationMatrix;
import org.robonewbie.simulator.soccer.Match;
import org.robonewbie.simulator.soccer.Player;
import org.robonewbie.simulator.world.LinkMotion;

/** Restores a world from two snapshots, deriving the velocities from their difference. */
final class Restoration {

    private final SimulationCycle cycle;

    Restoration(SimulationCycle cycle) {
        this.cycle = cycle;
    }

    void restore(WorldSnapshot before, WorldSnapshot target) {
        double seconds = target.seconds() - before.seconds();
        restoreGame(target);
        for (RobotSnapshot robot : target.robots()) {
            RobotSnapshot earlier = before.robots().stream()
                    .filter(each -> each.id() == robot.id() && each.type() == robot.type())
                    .findFirst()
                    .orElse(robot);
            player(robot).ifPresent(player -> player.robot().place(motions(earlier, robot, seconds)));
        }
        cycle.world().ball().place(LinkMotion.between(ball(before), ball(target), seconds));
        restoreThings(before.things(), target.things(), seconds);
    }

    private void restoreThings(List<Thing> before, List<Thing> now, double seconds) {
        List<Thing> present = cycle.world().things().landscape().things();
        for (int i = 0; i < Math.min(present.size(), now.size()); i++) {
            Thing earlier = i < before.size() ? before.get(i) : now.get(i);
            cycle.world()
                    .things()
                    .place(
                            i,
                            LinkMotion.between(
                                    BodyPose.of(earlier.pose()),
                                    BodyPose.of(now.get(i).pose()),
                                    seconds));
        }
    }

    private void restoreGame(WorldSnapshot target) {
        Match match = cycle.match();
        if (target.playMode() != match.state().playMode()) {
            match.setPlayMode(target.playMode());
        }
        match.state().setHalf(target.half());
        match.state().setPlaySeconds(target.gameTime());
        match.state().setScore(target.scoreLeft(), target.scoreRight());
    }

    private Optional<Player> player(RobotSnapshot robot) {
        return robot.side()
                .flatMap(side -> cycle.match().teams().player(side, robot.number()))
                .filter(player -> player.robot().type() == robot.type());
    }

    private static List<LinkMotion> motions(RobotSnapshot before, RobotSnapshot now, double seconds) {
        List<BodyPose> earlier = links(before);
        List<BodyPose> later = links(now);
        List<LinkMotion> motions = new ArrayList<>();
        for (int i = 0; i < later.size(); i++) {
            motions.add(LinkMotion.between(earlier.get(i), later.get(i), seconds));
        }
        return motions;
    }

    private static List<BodyPose> links(RobotSnapshot robot) {
        return robot.body().limbs().links().stream().map(BodyPose::ofBodyAxes).toList();
    }

    private static BodyPose ball(WorldSnapshot snapshot) {
        return new BodyPose(snapshot.ballPosition(), RotationMatrix.of(snapshot.ballRotation()));
    }
}
