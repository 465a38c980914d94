package org.robonewbie.agent.walk;

import java.util.ArrayList;
import java.util.List;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import org.robonewbie.agent.policy.InferenceSession;
import org.robonewbie.agent.policy.Policy;
import org.robonewbie.agent.policy.Quantity;
import org.robonewbie.nao.Vector3;
import org.robonewbie.nao.geometry.Translation2d;

/**
 * A policy that plays soccer with the walk: it observes where the ball, the goals and the other robots are, and chooses a velocity.
 *
 * <pre>{@code
 * WalkVelocity wanted = policy.velocity(nao.isFallen(), List.of(ball, opponentGoal, ownGoal, opponent));
 * walk.towards(wanted.forward(), wanted.left(), wanted.turn());
 * }</pre>
 *
 * <p>A point at the distance d is observed as its direction, a vector of length 1, times d / (d + 0.5 m): so all values are between -1 and
 * 1, and those of near points are precise.
 */
public final class SoccerPolicy {

    /** The velocity of an action whose components are all 1, which is the highest of the shipped walk. */
    public static final WalkVelocity MAX = new WalkVelocity(0.8, 0.2, 90);

    /** Names and units of an action's components. */
    public static final List<Quantity> OUTPUTS = List.of(
            Quantity.scaled("velocity.forward", MAX.forward(), "m/s"),
            Quantity.scaled("velocity.left", MAX.left(), "m/s"),
            Quantity.scaled("velocity.turn", MAX.turn(), "degrees/s"));

    /** Speed of a robot that walks backward, which is low since it sees little behind it. */
    private static final double MAX_BACKWARD = 0.1;

    private static final double HALF_WAY_METRES = 0.5;

    private final InferenceSession session;
    private final int cyclesPerAction;
    private int cycles;
    private WalkVelocity velocity = WalkVelocity.ZERO;

    /**
     * Creates a player for a policy.
     *
     * @param policy a policy from {@code python -m robonewbie.selfplay}
     * @param mates number of team mates that it observes
     * @param opponents number of opponents that it observes
     * @throws IllegalArgumentException if the policy has other inputs or outputs
     */
    public SoccerPolicy(Policy policy, int mates, int opponents) {
        policy.require(inputs(mates, opponents), OUTPUTS);
        session = policy.network().session();
        cyclesPerAction = policy.cyclesPerAction();
    }

    /**
     * Returns the names and units of the inputs.
     *
     * @param mates number of team mates
     * @param opponents number of opponents
     * @return the inputs, in the order of {@link #values}
     */
    public static List<Quantity> inputs(int mates, int opponents) {
        List<Quantity> all = new ArrayList<>(List.of(new Quantity("fallen", "1")));
        Stream.of(Stream.of("ball", "goal", "ownGoal"), names("mate", mates), names("opponent", opponents))
                .flatMap(names -> names)
                .forEach(name -> {
                    all.add(new Quantity(name + ".forward", "1"));
                    all.add(new Quantity(name + ".left", "1"));
                });
        return List.copyOf(all);
    }

    private static Stream<String> names(String name, int count) {
        return IntStream.rangeClosed(1, count).mapToObj(number -> name + number);
    }

    /**
     * Returns the inputs of a policy.
     *
     * @param fallen whether the robot lies on the ground
     * @param points positions of the ball, the centres of the opponents' and the own goal, the mates and the opponents, in the robot's frame,
     *     in metres: x forward, y left
     * @return values between -1 and 1
     */
    public static double[] values(boolean fallen, List<Vector3> points) {
        double[] all = new double[1 + 2 * points.size()];
        all[0] = fallen ? 1 : 0;
        for (int i = 0; i < points.size(); i++) {
            Vector3 point = points.get(i);
            double metres = new Translation2d(point.x(), point.y()).length();
            double factor = 1 / (metres + HALF_WAY_METRES);
            all[1 + 2 * i] = factor * point.x();
            all[2 + 2 * i] = factor * point.y();
        }
        return all;
    }

    /**
     * Returns the velocity for the walk. Call this method once per cycle; an action lasts as many cycles as in training.
     *
     * @param fallen whether the robot lies on the ground
     * @param points positions as for {@link #values}
     * @return the velocity
     */
    public WalkVelocity velocity(boolean fallen, List<Vector3> points) {
        if (cycles++ % cyclesPerAction == 0) {
            velocity = velocity(session.apply(values(fallen, points)));
        }
        return velocity;
    }

    /**
     * Returns the velocity that an action stands for. Backward, the robot walks at 0.1 m/s at most.
     *
     * @param action a value from -1 to 1 for each of the {@link #OUTPUTS}
     * @return the velocity
     */
    public static WalkVelocity velocity(double... action) {
        double forward = action[0] < 0 ? MAX_BACKWARD : MAX.forward();
        return new WalkVelocity(forward * action[0], MAX.left() * action[1], MAX.turn() * action[2]);
    }
}
