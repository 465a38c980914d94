package org.robonewbie.exercises;

import java.util.Locale;
import org.robonewbie.nao.Vector3;
import org.robonewbie.nao.geometry.Pose2d;
import org.robonewbie.nao.math.PortableMath;
import org.robonewbie.trial.RandomSource;
import org.robonewbie.trial.RobotStart;
import org.robonewbie.trial.Scene;
import org.robonewbie.trial.WorldState;

/**
 * Task: walk farther in 10 seconds than the standard walk does with its default parameters. The built-in fast walk does not
 * count.
 */
final class FasterWalkTask implements Task {

    private static final double FAR_METRES = 6.3;
    private static final double BEST_METRES = 6.8;
    private static final double ASIDE_METRES = 1;

    private static final double STARTING_METRES = 2;
    private static final double GIVEN_POINTS = 3;

    private final RecognisedGait gait = new RecognisedGait();
    private Pose2d start = new Pose2d(-5, 0, 0);
    private double metres;
    private double aside;
    private boolean fallen;

    @Override
    public Scene scene(RandomSource random) {
        start = new Pose2d(-5, random.between(-2, 2), random.between(-15, 15));
        return Scene.of(RobotStart.at(start).after("stand")).withBall(5.5, 3.7);
    }

    @Override
    public void see(WorldState state) {
        Vector3 torso = state.robot().position();
        double direction = PortableMath.toRadians(start.bearing(torso));
        double way = start.distance(torso);
        metres = way * PortableMath.cos(direction);
        aside = Math.max(aside, Math.abs(way * PortableMath.sin(direction)));
        fallen |= state.robot().isFallen();
        if (metres > STARTING_METRES) {
            gait.see(state.robot());
        }
    }

    @Override
    public boolean isDecided() {
        return fallen;
    }

    @Override
    public Score score() {
        String finding = String.format(
                Locale.ROOT,
                "%.2f m in 10 s, at most %.2f m to the side%s",
                metres,
                aside,
                fallen ? ", then a fall" : "");
        if (fallen) {
            return Score.failed(
                    metres / 2,
                    finding,
                    "The walk is too fast. Change one number at a time, and test each change several times.");
        }
        if (gait.isFastWalk()) {
            return Score.failed(
                    GIVEN_POINTS,
                    finding + ", with the framework's fast walk",
                    "WalkStyle.FAST and FastWalk belong to the framework; find your own numbers, starting from"
                            + " WalkStyle.coordinates().");
        }
        return metres >= FAR_METRES && aside <= ASIDE_METRES
                ? Score.passed(
                        (int) Math.round(7 + 3 * (metres - FAR_METRES) / (BEST_METRES - FAR_METRES)), finding, "")
                : Score.failed(
                        metres,
                        finding,
                        "With its default numbers, the framework's walk covers 5.8 m. Pass other numbers"
                                + " to walk.setStyle: let a program try many, keep the best ones, and vary them"
                                + " again.");
    }
}
