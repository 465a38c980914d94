package org.robonewbie.learning.environment;

import org.robonewbie.nao.geometry.Pose2d;
import org.robonewbie.trial.Trial;
import org.robonewbie.trial.WorldState;
import org.robonewbie.trial.measure.Distance;
import org.robonewbie.trial.measure.Standing;

/**
 * Walk ahead. Reward: 10 per metre along the first heading and 1 per second on the feet; −5 for a fall, so that a dive has no
 * gain. An episode begins with a light push from any side, so that no two are equal.
 */
final class WalkTraining extends TrainingTask {

    private static final double METRE_REWARD = 10;
    private static final double FALL_PENALTY = 5;
    private static final double MAX_NEWTONS = 40;
    private static final double GOAL_METRES = 2;

    private final Distance distance = new Distance();
    private final Standing standing = new Standing();

    @Override
    public void begin(Trial trial) {
        Pose2d centre = new Pose2d(0, 0, random().between(-180, 180));
        trial.robot(0).push(centre.point(random().between(0, MAX_NEWTONS), 0, 0));
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

    /** {@return whether the robot has got 2 m ahead on its feet} */
    @Override
    public boolean isDone() {
        return !hasFallen() && distance.value() >= GOAL_METRES;
    }

    @Override
    public double value() {
        return METRE_REWARD * distance.value() + standing.value() - (hasFallen() ? FALL_PENALTY : 0);
    }
}
