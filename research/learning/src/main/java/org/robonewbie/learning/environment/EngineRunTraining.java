package org.robonewbie.learning.environment;

import org.robonewbie.agent.walk.WalkVelocity;
import org.robonewbie.trial.RandomSource;
import org.robonewbie.trial.Trial;
import org.robonewbie.trial.WorldState;

/**
 * Task: run straight ahead by correcting the output of the walk engine at speeds beyond its limits. Without corrections,
 * the robot falls within two seconds.
 */
final class EngineRunTraining extends EngineFollowTraining {

    private static final double MIN = 0.7;
    private static final double MAX = 1.1;

    private double metres;

    @Override
    WalkVelocity draw(RandomSource random, WalkVelocity previous) {
        return previous.equals(WalkVelocity.ZERO) ? new WalkVelocity(random.between(MIN, MAX), 0, 0) : previous;
    }

    @Override
    public void begin(Trial trial) {
        super.begin(trial);
        pushOnce(trial);
    }

    @Override
    protected void see(WorldState first, WorldState now) {
        metres = first.place().ahead(now.place().point(0, 0, 0));
    }

    @Override
    public String rewardRule() {
        return "1 per metre along the initial heading; a fall costs 3. One speed of 0.7 to 1.1 m/s, in steps of "
                + "140 ms; a light push at the start";
    }

    @Override
    double metres() {
        return metres;
    }
}
