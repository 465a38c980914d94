package org.robonewbie.learning.gym;

import org.robonewbie.agent.walk.WalkVelocity;
import org.robonewbie.trial.RandomSource;

/**
 * Run straight ahead with a commanded speed from 0.9 to 1.3 m/s, the same for the whole episode. It pays as {@link GymFollow}, but an
 * error of 0.6 m/s costs 1. A robot that stands still earns nothing, one that dives loses 5.
 */
final class GymRun extends GymFollow {

    private static final double LEAST = 0.9;
    private static final double MOST = 1.3;

    /** Creates a run. */
    GymRun() {
        super(0.6);
    }

    @Override
    WalkVelocity any(RandomSource random, WalkVelocity before) {
        return before.equals(WalkVelocity.ZERO) ? new WalkVelocity(random.between(LEAST, MOST), 0, 0) : before;
    }
}
