package org.robonewbie.learning.environment;

import org.robonewbie.agent.walk.WalkVelocity;
import org.robonewbie.trial.RandomSource;

/**
 * Run straight ahead with a commanded speed from 0.9 to 1.3 m/s, the same for the whole episode, with the reward of {@link
 * FollowTraining} and a tolerance of 0.6 m/s.
 */
final class RunTraining extends FollowTraining {

    private static final double MIN = 0.9;
    private static final double MAX = 1.3;

    /** Creates a run. */
    RunTraining() {
        super(0.6);
    }

    @Override
    WalkVelocity any(RandomSource random, WalkVelocity before) {
        return before.equals(WalkVelocity.ZERO) ? new WalkVelocity(random.between(MIN, MAX), 0, 0) : before;
    }
}
