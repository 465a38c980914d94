package org.robonewbie.exercises;

import org.robonewbie.nao.Joint;
import org.robonewbie.nao.Vector3;
import org.robonewbie.nao.geometry.Pose2d;
import org.robonewbie.trial.RandomSource;
import org.robonewbie.trial.RobotStart;
import org.robonewbie.trial.Scene;
import org.robonewbie.trial.Trial;
import org.robonewbie.trial.WorldState;
import org.robonewbie.trial.measure.SustainedCondition;

/** Task: look at a ball that rolls past the robot, first on the left, then on the right. */
final class LookAtBallTask implements Task {

    private static final Pose2d STUDENT = new Pose2d(-1, 0, 0);
    private static final Vector3 VELOCITY = new Vector3(0, -1.6, 0);
    private static final double ROLLS_FROM_SECONDS = 1;
    private static final double ASIDE_DEGREES = 15;
    private static final double AT_BALL_DEGREES = 10;
    private static final double LOOKED_SECONDS = 0.4;

    private final SustainedCondition left = looking(1);
    private final SustainedCondition right = looking(-1);
    private boolean rolls;

    private static SustainedCondition looking(int side) {
        return new SustainedCondition(LOOKED_SECONDS, state -> {
            double bearing = state.place().bearing(state.ball());
            double gap = Math.abs(bearing - state.robot().degrees(Joint.NECK_YAW));
            return side * bearing > ASIDE_DEGREES && gap < AT_BALL_DEGREES;
        });
    }

    @Override
    public Scene scene(RandomSource random) {
        return Scene.of(RobotStart.at(STUDENT).after("stand")).withBall(STUDENT.pointAt(0.5, 0.5));
    }

    @Override
    public void act(Trial trial) {
        if (!rolls && trial.seconds() >= ROLLS_FROM_SECONDS) {
            trial.ball().setVelocity(VELOCITY);
            rolls = true;
        }
    }

    @Override
    public void see(WorldState state) {
        left.see(state);
        right.see(state);
    }

    @Override
    public boolean isDecided() {
        return left.isDecided() && right.isDecided();
    }

    @Override
    public Score score() {
        if (isDecided()) {
            return Score.passed("the head followed the ball");
        }
        return Score.failed(
                left.isDecided() || right.isDecided() ? 5 : 0,
                "the head did not follow the ball",
                "In each cycle, set the angle of Joint.NECK_YAW to the direction of the ball.");
    }
}
