package org.robonewbie.learning.environment;

import org.robonewbie.agent.walk.WalkVelocity;
import org.robonewbie.trial.RandomSource;

/**
 * Task: run straight ahead at a commanded speed of 0.9 to 1.3 m/s, constant within an episode. The reward is that of
 * {@link FollowTraining}, but the linear error is divided by 0.6 m/s.
 */
final class RunTraining extends FollowTraining {

    private static final double MIN = 0.9;
    private static final double MAX = 1.3;

    RunTraining() {
        super(0.6);
    }

    @Override
    WalkVelocity draw(RandomSource random, WalkVelocity previous) {
        return previous.equals(WalkVelocity.ZERO) ? new WalkVelocity(random.between(MIN, MAX), 0, 0) : previous;
    }
}
