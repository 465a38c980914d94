package org.robonewbie.learning.environment;

import org.robonewbie.agent.walk.WalkVelocity;
import org.robonewbie.nao.geometry.Pose2d;
import org.robonewbie.trial.RandomSource;
import org.robonewbie.trial.Trial;
import org.robonewbie.trial.WorldState;

/**
 * Run straight ahead for 10 s by correcting the walk engine at speeds that it cannot do: a robot that corrects nothing falls
 * within two seconds. Reward: 1 per metre along the first heading; −3 for a fall. The robot is pushed once at the beginning,
 * from any side.
 */
final class EngineRunTraining extends EngineFollowTraining {

    private static final double MIN = 0.7;
    private static final double MAX = 1.1;
    private static final double MAX_NEWTONS = 40;

    private double metres;

    @Override
    WalkVelocity any(RandomSource random, WalkVelocity before) {
        return before.equals(WalkVelocity.ZERO) ? new WalkVelocity(random.between(MIN, MAX), 0, 0) : before;
    }

    @Override
    public void begin(Trial trial) {
        super.begin(trial);
        Pose2d centre = new Pose2d(0, 0, random().between(-180, 180));
        trial.robot(0).push(centre.point(random().between(0, MAX_NEWTONS), 0, 0));
    }

    @Override
    protected void see(WorldState first, WorldState now) {
        metres = first.place().ahead(now.place().point(0, 0, 0));
    }

    @Override
    double metres() {
        return metres;
    }
}
