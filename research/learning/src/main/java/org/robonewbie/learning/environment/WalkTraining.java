package org.robonewbie.learning.environment;

import org.robonewbie.trial.Trial;
import org.robonewbie.trial.WorldState;
import org.robonewbie.trial.measure.Distance;
import org.robonewbie.trial.measure.Standing;

/** Task: walk forward. A fall costs so much that diving forward does not pay off. */
final class WalkTraining extends TrainingTask {

    private static final double METRE_REWARD = 10;
    private static final double FALL_PENALTY = 5;
    private static final double GOAL_METRES = 2;

    private final Distance distance = new Distance();
    private final Standing standing = new Standing();

    @Override
    public void begin(Trial trial) {
        pushOnce(trial);
    }

    @Override
    public double rangeDegrees() {
        return 40;
    }

    @Override
    protected void see(WorldState first, WorldState now) {
        distance.see(now);
        standing.see(now);
    }

    /** {@return whether the robot has walked 2 m forward without a fall} */
    @Override
    public boolean isDone() {
        return !hasFallen() && distance.value() >= GOAL_METRES;
    }

    @Override
    public String rewardRule() {
        return "10 per metre along the initial heading and 1 per second without a fall; a fall costs 5. A light "
                + "push at the start";
    }

    @Override
    public String successRule() {
        return "2 m ahead without a fall";
    }

    @Override
    public double value() {
        return METRE_REWARD * distance.value() + standing.value() - (hasFallen() ? FALL_PENALTY : 0);
    }
}
