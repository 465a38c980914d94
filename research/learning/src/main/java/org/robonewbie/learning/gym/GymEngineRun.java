package org.robonewbie.learning.gym;

import org.robonewbie.agent.walk.WalkVelocity;
import org.robonewbie.nao.geometry.Pose2d;
import org.robonewbie.trial.RandomSource;
import org.robonewbie.trial.Trial;
import org.robonewbie.trial.WorldState;

/**
 * Run straight ahead for 10 s by correcting the walk engine, which is asked for more than it can do: a robot that corrects nothing
 * falls within two seconds. It pays 1 per metre along the first heading, and a fall costs 3. Someone pushes the robot at the
 * beginning, from in front or from behind.
 */
final class GymEngineRun extends GymEngineTask {

    private static final double LEAST = 0.7;
    private static final double MOST = 1.1;
    private static final double MOST_NEWTONS = 40;

    private double metres;

    @Override
    WalkVelocity any(RandomSource random, WalkVelocity before) {
        return before.equals(WalkVelocity.ZERO) ? new WalkVelocity(random.between(LEAST, MOST), 0, 0) : before;
    }

    @Override
    public void begin(Trial trial) {
        super.begin(trial);
        Pose2d centre = new Pose2d(0, 0, chance().between(-180, 180));
        trial.robot(0).push(centre.point(chance().between(0, MOST_NEWTONS), 0, 0));
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
