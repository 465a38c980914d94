package org.robonewbie.learning.environment;

import java.util.ArrayDeque;
import java.util.Deque;
import java.util.List;
import org.robonewbie.agent.walk.WalkVelocity;
import org.robonewbie.nao.Cycle;
import org.robonewbie.nao.geometry.Pose2d;
import org.robonewbie.trial.RandomSource;
import org.robonewbie.trial.WorldState;

/**
 * Follow a commanded velocity, another one every 3 s. Reward per second: 1 less the error of the velocity in the last 0.4 s
 * (1 for 0.3 m/s or 90°/s, together 1.5 at most); −5 for a fall, so that a dive has no gain.
 */
class FollowTraining extends CommandedTraining {

    private static final WalkVelocity MAX = new WalkVelocity(0.8, 0.2, 90);
    private static final double BACKWARD = 0.3;
    private static final int WINDOW = 20;
    private static final double DEFAULT_METRES_PER_SECOND = 0.3;
    private static final double DEGREES_PER_SECOND = 90;
    private static final double FALL_PENALTY = 5;
    private static final double DONE_PART = 0.5;

    private final Deque<Pose2d> places = new ArrayDeque<>();
    private final double toleratedMetresPerSecond;
    private double totalReward;
    private double maxReward;

    /** Creates the task. */
    FollowTraining() {
        this(DEFAULT_METRES_PER_SECOND);
    }

    /** Creates a task with another tolerance: the error of the velocity that leaves no reward. */
    FollowTraining(double toleratedMetresPerSecond) {
        this.toleratedMetresPerSecond = toleratedMetresPerSecond;
    }

    @Override
    WalkVelocity any(RandomSource random, WalkVelocity before) {
        return new WalkVelocity(
                        random.between(-BACKWARD, MAX.forward()),
                        random.between(-MAX.left(), MAX.left()),
                        random.between(-MAX.turn(), MAX.turn()))
                .within(MAX, BACKWARD);
    }

    @Override
    public double rangeDegrees() {
        return 40;
    }

    @Override
    public List<ObservedQuantity> extraQuantities() {
        return List.of(
                new ObservedQuantity(
                        "command.forward", "m/s", -DomainRandomization.MAX_SPEED, DomainRandomization.MAX_SPEED),
                new ObservedQuantity(
                        "command.left", "m/s", -DomainRandomization.MAX_SPEED, DomainRandomization.MAX_SPEED),
                new ObservedQuantity(
                        "command.turn", "degrees/s", -DomainRandomization.MAX_TURN, DomainRandomization.MAX_TURN));
    }

    @Override
    public double[] extras() {
        return new double[] {velocity().forward(), velocity().left(), velocity().turn()};
    }

    @Override
    protected void see(WorldState first, WorldState now) {
        places.addLast(now.place(robot()));
        if (places.size() > WINDOW) {
            maxReward += Cycle.SECONDS;
            totalReward += Cycle.SECONDS
                    * (1
                            - VelocityError.between(
                                            places.removeFirst(), places.getLast(), WINDOW * Cycle.SECONDS, velocity())
                                    .cost(toleratedMetresPerSecond, DEGREES_PER_SECOND));
        }
    }

    /** {@return whether the robot is on its feet and has half of the largest return: a mean error of 0.15 m/s, or of 45°/s, or a part of both} */
    @Override
    public boolean isDone() {
        return !hasFallen() && maxReward > 0 && totalReward >= DONE_PART * maxReward;
    }

    @Override
    public double value() {
        return totalReward - (hasFallen() ? FALL_PENALTY : 0);
    }
}
