package org.robonewbie.learning.environment;

import java.util.Optional;
import org.robonewbie.agent.policy.Policy;
import org.robonewbie.agent.walk.ResidualPolicy;
import org.robonewbie.agent.walk.WalkVelocity;
import org.robonewbie.nao.Cycle;
import org.robonewbie.nao.Vector3;
import org.robonewbie.nao.geometry.Pose2d;
import org.robonewbie.trial.RandomSource;
import org.robonewbie.trial.WorldState;

/**
 * Task: follow velocities beyond the limits of the walk engine by correcting its output. Without corrections, the robot
 * falls within a few seconds.
 */
class EngineFollowTraining extends CommandedTraining {

    private static final Policy ENGINE = WalkGuide.engine(140, new WalkVelocity(1.3, 0.2, 60), 0.3);
    private static final double MIN = 0.6;
    private static final double MAX = 1;
    private static final double MAX_TURN = 30;
    private static final double FALL_PENALTY = 3;
    private static final double GOAL_METRES = 5;

    private Optional<Pose2d> before = Optional.empty();
    private double turned;
    private double metres;

    @Override
    public final Optional<Policy> walk() {
        return Optional.of(ENGINE);
    }

    @Override
    public final double rangeDegrees() {
        return ResidualPolicy.RANGE_DEGREES;
    }

    @Override
    WalkVelocity draw(RandomSource random, WalkVelocity previous) {
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

    /** Returns the distance covered along the commanded path, in metres. */
    double metres() {
        return metres;
    }

    /** {@return whether the robot has covered 5 m along the commanded path without a fall} */
    @Override
    public final boolean isDone() {
        return !hasFallen() && metres() >= GOAL_METRES;
    }

    @Override
    public String rewardRule() {
        return "1 per metre in the commanded direction; a fall costs 3. Every 3 s a new command: 0.6 to 1 m/s "
                + "ahead and up to 30 degrees/s to a side, in steps of 140 ms";
    }

    @Override
    public String successRule() {
        return "5 m without a fall";
    }

    @Override
    public final double value() {
        return metres() - (hasFallen() ? FALL_PENALTY : 0);
    }
}
