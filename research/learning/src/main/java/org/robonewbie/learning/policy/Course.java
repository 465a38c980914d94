package org.robonewbie.learning.policy;

import java.util.List;
import org.robonewbie.agent.policy.Policy;

/**
 * What can be learned by trying, lesson by lesson: the numbers that are changed, what they mean, and where lessons are given.
 *
 * <pre>{@code
 * try (Classroom room = course.open(plan)) {
 *     double reward = room.give(1, course.start(1)).reward();
 * }
 * }</pre>
 */
public interface Course {

    /** {@return what it is called} */
    String task();

    /**
     * Says what decides about the result of a training.
     *
     * @param plan how somebody learns
     * @return words that can be given to {@code robonewbie learn} again
     * @throws IllegalArgumentException if the plan says something that has no meaning here
     */
    String words(TrainingPlan plan);

    /**
     * Makes the first guess of a robot that knows nothing.
     *
     * @param seed chooses what is random in it
     * @return the numbers
     */
    double[] start(long seed);

    /**
     * Takes the numbers of a policy that is to be improved.
     *
     * @param policy what was learned before
     * @return the numbers
     * @throws IllegalArgumentException if it was learned for something else
     */
    double[] start(Policy policy);

    /** {@return by how much each number is usually changed} */
    double[] units();

    /**
     * Makes a policy.
     *
     * @param about how it was learned, in lines for people
     * @param numbers what was learned
     * @return the policy
     */
    Policy policy(List<String> about, double... numbers);

    /**
     * Makes a policy that was learned after a plan. It is played in the same way, such as with actions that last as many cycles.
     *
     * @param plan how it was learned
     * @param about how it was learned, in lines for people
     * @param numbers what was learned
     * @return the policy
     */
    default Policy policy(TrainingPlan plan, List<String> about, double... numbers) {
        return policy(about, numbers);
    }

    /**
     * Opens a world for lessons, one after the other.
     *
     * @param plan how somebody learns
     * @return the world
     */
    Classroom open(TrainingPlan plan);
}
