package org.robonewbie.exercises;

import java.util.Locale;
import org.robonewbie.nao.geometry.Pose2d;
import org.robonewbie.trial.RandomSource;
import org.robonewbie.trial.RobotStart;
import org.robonewbie.trial.Scene;
import org.robonewbie.trial.WorldState;
import org.robonewbie.trial.measure.SustainedCondition;

/** Task: find a ball that is out of view and face it for a second. */
final class FindTheBallTask implements Task {

    private static final Pose2d STUDENT = new Pose2d(-0.5, 0, 30);
    private static final double FACING_DEGREES = 10;
    private static final double HELD_SECONDS = 1;
    private static final double LIMIT_SECONDS = 8;
    private static final double QUICK_SECONDS = 5.5;

    private final SustainedCondition facing = new SustainedCondition(
            HELD_SECONDS, state -> Math.abs(state.place().bearing(state.ball())) <= FACING_DEGREES);
    private double bearing;

    @Override
    public Scene scene(RandomSource random) {
        double side = random.isSeedOdd() ? 1 : -1;
        return Scene.of(RobotStart.at(STUDENT).after("stand"))
                .withBall(STUDENT.point(random.between(1, 2.5), side * random.between(100, 150), 0));
    }

    @Override
    public void see(WorldState state) {
        bearing = state.place().bearing(state.ball());
        facing.see(state);
    }

    @Override
    public boolean isDecided() {
        return facing.isDecided();
    }

    @Override
    public Score score() {
        double foundSeconds = facing.value();
        if (facing.isDecided() && foundSeconds <= LIMIT_SECONDS) {
            int points = (int) Math.round(10 - 2 * Math.max(0, foundSeconds - QUICK_SECONDS));
            return Score.passed(
                    points,
                    String.format(Locale.ROOT, "faced the ball after %.1f s", foundSeconds),
                    points < 10
                            ? "The head turns faster than the robot. Once the camera sees the ball, you know which"
                                    + " way to turn."
                            : "");
        }
        return Score.failed(
                2,
                String.format(Locale.ROOT, "the ball is still %.0f° to the side", bearing),
                "Turn the head with lookAround.look() while the feet turn, and continue until the bearing is within"
                        + " 10°.");
    }
}
