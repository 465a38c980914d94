package org.robonewbie.learning.environment;

import org.robonewbie.nao.Vector3;
import org.robonewbie.trial.RandomSource;
import org.robonewbie.trial.Scene;
import org.robonewbie.trial.Trial;
import org.robonewbie.trial.WorldState;
import org.robonewbie.trial.measure.KickDistance;

/** Task: kick the ball forward. The ball lies in front of the right foot. */
final class KickTraining extends TrainingTask {

    private static final Vector3 BALL = new Vector3(-2 + 0.19, -0.055, 0);
    private static final Scene SCENE = scene(-2).withBall(BALL);
    private static final double SPREAD_METRES = 0.01;
    private static final double GOAL_METRES = 3;

    private final KickDistance distance = new KickDistance();

    @Override
    public Scene scene(RandomSource random) {
        return SCENE;
    }

    @Override
    public void begin(Trial trial) {
        scatterBall(trial, SPREAD_METRES);
    }

    @Override
    public double rangeDegrees() {
        return 60;
    }

    @Override
    public int longestCycles() {
        return 250;
    }

    @Override
    public boolean hasCamera() {
        return true;
    }

    @Override
    protected void see(WorldState first, WorldState now) {
        distance.see(now);
    }

    /** {@return whether the ball rolls at least 3 m forward and the robot has not fallen} */
    @Override
    public boolean isDone() {
        return !hasFallen() && distance.value() >= GOAL_METRES;
    }

    @Override
    public String rewardRule() {
        return "1 per metre that the ball moves forward, including the roll still to come; a fall costs 1";
    }

    @Override
    public String successRule() {
        return "3 m without a fall";
    }

    @Override
    public double value() {
        return distance.value() - (hasFallen() ? 1 : 0);
    }
}
