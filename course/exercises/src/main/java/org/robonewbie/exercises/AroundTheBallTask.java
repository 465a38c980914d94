package org.robonewbie.exercises;

import java.util.Locale;
import org.robonewbie.nao.Vector3;
import org.robonewbie.nao.geometry.Angles;
import org.robonewbie.nao.geometry.Pose2d;
import org.robonewbie.trial.RandomSource;
import org.robonewbie.trial.RobotStart;
import org.robonewbie.trial.Scene;
import org.robonewbie.trial.WorldState;

/** Task: walk once around the ball without touching it or moving too far away from it. */
final class AroundTheBallTask implements Task {

    private static final Pose2d STUDENT = new Pose2d(-0.8, 0, 0);
    private static final double MOVED_METRES = 0.002;
    private static final double NEAR_METRES = 0.9;
    private static final double FAR_METRES = 2;

    private Vector3 ballStart = Vector3.ZERO;
    private double directionBefore;
    private double turned;
    private double moved;
    private double farthest;
    private double seconds;

    @Override
    public Scene scene(RandomSource random) {
        return Scene.of(RobotStart.at(STUDENT).after("stand"))
                .withBall(STUDENT.point(random.between(1, 1.6), random.side() * random.between(20, 45), 0));
    }

    @Override
    public void see(WorldState state) {
        double direction = direction(state);
        if (state.seconds() == 0) {
            ballStart = state.ball();
            directionBefore = direction;
        }
        if (state.place().distance(state.ball()) <= NEAR_METRES) {
            turned += Angles.wrap(direction - directionBefore);
        }
        directionBefore = direction;
        moved = Math.max(moved, state.ball().distanceTo(ballStart));
        farthest = Math.max(farthest, state.place().distance(ballStart));
        seconds = state.seconds();
    }

    @Override
    public boolean isDecided() {
        return Math.abs(turned) >= 360 || moved > MOVED_METRES || farthest > FAR_METRES;
    }

    @Override
    public Score score() {
        String finding = String.format(
                Locale.ROOT,
                "%.0f° around the ball within 0.9 m in %.1f s, ball moved by %.3f m",
                Math.abs(turned),
                seconds,
                moved);
        if (moved > MOVED_METRES) {
            return Score.failed(
                    Math.abs(turned) / 60,
                    finding,
                    "Keep a greater distance: a fieldView.ball().distance() of 0.5 m is safe.");
        }
        if (farthest > FAR_METRES) {
            return Score.failed(
                    Math.abs(turned) / 60, finding, "Stay within 2 m of the ball and keep your eyes on it.");
        }
        return Math.abs(turned) >= 360
                ? Score.passed(finding)
                : Score.failed(
                        Math.abs(turned) / 45,
                        finding,
                        "Stay within 0.9 m and walk sideways while you turn towards the ball: walk.towards(forward,"
                                + " left, turn) does all three at once.");
    }

    private static double direction(WorldState state) {
        Pose2d here = state.place();
        Vector3 ball = state.ball();
        return Angles.atan2(here.y() - ball.y(), here.x() - ball.x());
    }
}
