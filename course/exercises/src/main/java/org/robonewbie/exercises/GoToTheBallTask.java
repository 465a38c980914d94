package org.robonewbie.exercises;

import java.util.Locale;
import org.robonewbie.nao.Joint;
import org.robonewbie.nao.Vector3;
import org.robonewbie.nao.geometry.Pose2d;
import org.robonewbie.trial.RandomSource;
import org.robonewbie.trial.RobotStart;
import org.robonewbie.trial.Scene;
import org.robonewbie.trial.WorldState;
import org.robonewbie.trial.measure.SustainedCondition;

/** Task: walk to the ball, stop in front of it without touching it, and raise the arm. */
final class GoToTheBallTask implements Task {

    private static final double NEAR_METRES = 0.5;
    private static final double FACING_DEGREES = 20;
    private static final double MOVED_METRES = 0.02;
    private static final double UP_DEGREES = 60;
    private static final double HELD_SECONDS = 1;

    private Vector3 ballStart = Vector3.ZERO;
    private double nearest = Double.POSITIVE_INFINITY;
    private double moved;
    private boolean fallen;
    private final SustainedCondition done = new SustainedCondition(HELD_SECONDS, GoToTheBallTask::isDone);

    @Override
    public Scene scene(RandomSource random) {
        Pose2d start = new Pose2d(-2.5, random.between(-1, 1), random.between(-60, 60));
        return Scene.of(RobotStart.at(start).after("stand"))
                .withBall(start.point(random.between(1.5, 2.5), random.between(-50, 50), 0));
    }

    @Override
    public void see(WorldState state) {
        ballStart = state.seconds() == 0 ? state.ball() : ballStart;
        moved = Math.max(moved, state.ball().distanceTo(ballStart));
        fallen |= state.robot().isFallen();
        nearest = Math.min(nearest, state.place().distance(state.ball()));
        done.see(state);
    }

    private static boolean isDone(WorldState state) {
        return state.place().distance(state.ball()) <= NEAR_METRES
                && Math.abs(state.place().bearing(state.ball())) <= FACING_DEGREES
                && state.robot().degrees(Joint.LEFT_SHOULDER_PITCH) >= UP_DEGREES;
    }

    @Override
    public boolean isDecided() {
        return done.isDecided() || moved > MOVED_METRES;
    }

    @Override
    public Score score() {
        String finding = String.format(
                Locale.ROOT,
                "came within %.2f m, ball moved by %.3f m%s",
                nearest,
                moved,
                fallen ? ", and a fall" : "");
        if (moved > MOVED_METRES) {
            return Score.failed(
                    3,
                    finding,
                    "The feet reach further ahead than the torso: stop when fieldView.ball().distance() is 0.4 m, and"
                            + " slow down before that.");
        }
        if (!done.isDecided()) {
            return Score.failed(
                    nearest <= NEAR_METRES ? 4 : 1,
                    finding,
                    "When the robot is within 0.5 m of the ball and faces it, the left shoulder must be above 60° for 1 s.");
        }
        return Score.passed(String.format(Locale.ROOT, "%s, done after %.1f s", finding, done.value()));
    }
}
