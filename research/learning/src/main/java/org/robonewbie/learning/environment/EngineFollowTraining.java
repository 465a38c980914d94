package org.robonewbie.learning.environment;

import java.util.Optional;
import org.robonewbie.agent.walk.WalkVelocity;
import org.robonewbie.nao.Cycle;
import org.robonewbie.nao.Vector3;
import org.robonewbie.nao.geometry.Pose2d;
import org.robonewbie.trial.RandomSource;
import org.robonewbie.trial.WorldState;

/**
 * Follow velocities that are too fast for the walk engine by correcting it: ahead with 0.6 to 1 m/s while turning by up to
 * 30°/s, another one every 3 s. A robot that corrects nothing falls within a few seconds. Reward: 1 per metre in the
 * commanded heading; −3 for a fall.
 */
class EngineFollowTraining extends EngineTraining {

    private static final double MIN = 0.6;
    private static final double MAX = 1;
    private static final double MAX_TURN = 30;
    private static final double FALL_PENALTY = 3;
    private static final double GOAL_METRES = 5;

    private Optional<Pose2d> before = Optional.empty();
    private double turned;
    private double metres;

    @Override
    WalkVelocity any(RandomSource random, WalkVelocity last) {
        return new WalkVelocity(random.between(MIN, MAX), 0, random.between(-MAX_TURN, MAX_TURN));
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

    /** How far the robot has got on the commanded way. */
    double metres() {
        return metres;
    }

    /** {@return whether the robot has got 5 m along the commanded way, on its feet} */
    @Override
    public final boolean isDone() {
        return !hasFallen() && metres() >= GOAL_METRES;
    }

    @Override
    public final double value() {
        return metres() - (hasFallen() ? FALL_PENALTY : 0);
    }
}
