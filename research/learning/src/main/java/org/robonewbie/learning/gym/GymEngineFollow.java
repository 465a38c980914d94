package org.robonewbie.learning.gym;

import java.util.Optional;
import org.robonewbie.agent.walk.WalkVelocity;
import org.robonewbie.nao.Cycle;
import org.robonewbie.nao.Vector3;
import org.robonewbie.nao.geometry.Pose2d;
import org.robonewbie.trial.RandomSource;
import org.robonewbie.trial.WorldState;

/**
 * Follow velocities that are too fast for the walk engine by correcting it: ahead with 0.6 to 1 m/s while turning by up to 30°/s,
 * another one every 3 s. A robot that corrects nothing falls within a few seconds. It pays 1 per metre into the direction in which
 * the robot would look if it had turned as it was told, and a fall costs 3.
 */
final class GymEngineFollow extends GymEngineTask {

    private static final double LEAST = 0.6;
    private static final double MOST = 1;
    private static final double MOST_TURN = 30;

    private Optional<Pose2d> before = Optional.empty();
    private double turned;
    private double metres;

    @Override
    WalkVelocity any(RandomSource random, WalkVelocity last) {
        return new WalkVelocity(random.between(LEAST, MOST), 0, random.between(-MOST_TURN, MOST_TURN));
    }

    @Override
    protected void see(WorldState first, WorldState now) {
        Vector3 here = now.robot().position();
        before.ifPresent(place -> {
            turned += velocity().turn() * Cycle.SECONDS;
            metres += new Pose2d(place.x(), place.y(), first.place().degrees() + turned).ahead(here);
        });
        before = Optional.of(now.place());
    }

    @Override
    double metres() {
        return metres;
    }
}
