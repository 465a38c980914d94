package org.robonewbie.exercises;

import java.util.Locale;
import org.robonewbie.nao.geometry.Pose2d;
import org.robonewbie.simulator.landscape.Landscape;
import org.robonewbie.simulator.landscape.Thing;
import org.robonewbie.trial.RandomSource;
import org.robonewbie.trial.RobotStart;
import org.robonewbie.trial.Scene;
import org.robonewbie.trial.WorldState;

/**
 * Task: with two robots, push a wide box over a line without rotating it. One robot starts farther from the box than the
 * other.
 */
final class PushTogetherTask implements Task {

    private static final double LINE_METRES = -1.2;
    private static final double STRAIGHT_DEGREES = 12;
    private static final double APART_METRES = 0.45;

    private double x = Double.NEGATIVE_INFINITY;
    private double turned;
    private double seconds;
    private boolean fallen;

    @Override
    public Scene scene(RandomSource random) {
        double side = random.side();
        Pose2d near = new Pose2d(-4, side * APART_METRES, random.between(-8, 8));
        Pose2d far = new Pose2d(-4 - random.between(0.6, 1), -side * APART_METRES, random.between(-8, 8));
        boolean firstIsNear = random.side() > 0;
        return Scene.of(
                        RobotStart.at(firstIsNear ? near : far).after("stand"),
                        RobotStart.at(firstIsNear ? far : near).after("stand").withTeam(RobotStart.TEAM, 2))
                .withLandscape(Landscape.BOX)
                .withBall(4, 0);
    }

    @Override
    public void see(WorldState state) {
        Thing box = state.things().get(0);
        x = box.centre().x();
        turned = Math.max(turned, box.pose().rotation().angleDegrees());
        seconds = state.seconds();
        fallen |= state.robots().stream().anyMatch(robot -> robot.isFallen());
    }

    @Override
    public boolean isDecided() {
        return x >= LINE_METRES || turned > STRAIGHT_DEGREES;
    }

    @Override
    public Score score() {
        double start = Landscape.BOX.things().get(0).centre().x();
        double pushed = Math.max(0, x - start);
        String finding = String.format(
                Locale.ROOT,
                "pushed %.2f of %.2f m in %.0f s, turned by %.0f°%s",
                pushed,
                LINE_METRES - start,
                seconds,
                turned,
                fallen ? ", and a fall" : "");
        if (turned > STRAIGHT_DEGREES) {
            return Score.failed(
                    Math.min(3, 2 * pushed),
                    finding,
                    "The first robot at the box waits and says so: nao.say(\"ready\"). When both are there, both push at the same"
                            + " speed.");
        }
        return x >= LINE_METRES
                ? Score.passed(finding)
                : Score.failed(
                        Math.min(5, 3 * pushed),
                        finding,
                        "The box starts 0.6 m ahead of the nearer robot. Walk straight into it; SelfLocalisation"
                                + " shows how far you have come and helps you keep your heading at 0°.");
    }
}
