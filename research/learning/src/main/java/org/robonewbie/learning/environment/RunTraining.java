package org.robonewbie.learning.environment;

import org.robonewbie.agent.walk.WalkVelocity;
import org.robonewbie.trial.RandomSource;

/** Task: run straight ahead at a commanded speed that is constant within an episode. */
final class RunTraining extends FollowTraining {

    private static final double MIN = 0.9;
    private static final double MAX = 1.3;

    RunTraining() {
        super(0.6);
    }

    @Override
    public String rewardRule() {
        return "as Follow, with one speed of 0.9 to 1.3 m/s straight ahead; an error of 0.6 m/s costs 1";
    }

    @Override
    public String successRule() {
        return "no fall, and a mean error of at most 0.3 m/s or 45 degrees/s, or a mixture of both";
    }

    @Override
    WalkVelocity draw(RandomSource random, WalkVelocity previous) {
        return previous.equals(WalkVelocity.ZERO) ? new WalkVelocity(random.between(MIN, MAX), 0, 0) : previous;
    }
}
