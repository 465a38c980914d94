package org.robonewbie.learning.environment;

import java.util.ArrayDeque;
import java.util.Deque;
import java.util.List;
import org.robonewbie.agent.walk.WalkVelocity;
import org.robonewbie.nao.Cycle;
import org.robonewbie.nao.geometry.Pose2d;
import org.robonewbie.trial.RandomSource;
import org.robonewbie.trial.WorldState;

/** Task: follow a commanded velocity. A fall costs so much that diving forward does not pay off. */
class FollowTraining extends CommandedTraining {

    private static final WalkVelocity MAX = new WalkVelocity(0.8, 0.2, 90);
    private static final double BACKWARD = 0.3;
    private static final int WINDOW = 20;
    private static final double DEFAULT_METRES_PER_SECOND = 0.3;
    private static final double DEGREES_PER_SECOND = 90;
    private static final double FALL_PENALTY = 5;
    private static final double DONE_SHARE = 0.5;

    private final Deque<Pose2d> places = new ArrayDeque<>();
    private final double toleratedMetresPerSecond;
    private double totalReward;
    private double maxReward;

    FollowTraining() {
        this(DEFAULT_METRES_PER_SECOND);
    }

    /** Creates a task whose reward is 0 at a given velocity error. */
    FollowTraining(double toleratedMetresPerSecond) {
        this.toleratedMetresPerSecond = toleratedMetresPerSecond;
    }

    @Override
    WalkVelocity draw(RandomSource random, WalkVelocity previous) {
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
                ObservedQuantity.symmetric("command.forward", "m/s", DomainRandomization.MAX_SPEED),
                ObservedQuantity.symmetric("command.left", "m/s", DomainRandomization.MAX_SPEED),
                ObservedQuantity.symmetric("command.turn", "degrees/s", DomainRandomization.MAX_TURN));
    }

    @Override
    public double[] extras() {
        return new double[] {velocity().forward(), velocity().left(), velocity().turn()};
    }

    @Override
    protected void see(WorldState first, WorldState now) {
        places.addLast(now.place(robot()));
        if (places.size() > WINDOW) {
            VelocityError error =
                    VelocityError.between(places.removeFirst(), places.getLast(), WINDOW * Cycle.SECONDS, velocity());
            maxReward += Cycle.SECONDS;
            totalReward += Cycle.SECONDS * (1 - error.cost(toleratedMetresPerSecond, DEGREES_PER_SECOND));
        }
    }

    /**
     * {@return whether the robot has not fallen and has reached half of the maximum return, which corresponds to a mean
     * error of 0.15 m/s or 45°/s}
     */
    @Override
    public boolean isDone() {
        return !hasFallen() && maxReward > 0 && totalReward >= DONE_SHARE * maxReward;
    }

    @Override
    public String rewardRule() {
        return "1 per second, minus the velocity error over the last 0.4 s (1 for 0.3 m/s or 90 degrees/s, at "
                + "most 1.5); a fall costs 5";
    }

    @Override
    public String successRule() {
        return "no fall, and a mean error of at most 0.15 m/s or 45 degrees/s, or a mixture of both";
    }

    @Override
    public double value() {
        return totalReward - (hasFallen() ? FALL_PENALTY : 0);
    }
}
