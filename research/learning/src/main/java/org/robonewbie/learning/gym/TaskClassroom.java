package org.robonewbie.learning.gym;

import java.util.List;
import org.robonewbie.agent.policy.Network;
import org.robonewbie.agent.policy.Policy;
import org.robonewbie.agent.policy.Quantity;
import org.robonewbie.learning.policy.Classroom;
import org.robonewbie.learning.policy.LessonFigures;

/** A world in which a robot lives through episodes of a task, played by a network. */
final class TaskClassroom implements Classroom {

    private final GymEnvironment environment;
    private final GymOptions options;
    private final TaskCourse course;

    TaskClassroom(GymEnvironment environment, GymOptions options, TaskCourse course) {
        this.environment = environment;
        this.options = options;
        this.course = course;
    }

    @Override
    public LessonFigures give(long seed, double... numbers) {
        return examine(seed, course.policy(List.of(), numbers));
    }

    @Override
    public LessonFigures examine(long seed, Policy policy) {
        Network network = policy.network();
        int[] places = policy.inputs().stream().mapToInt(this::place).toArray();
        environment.setOptions(options.withUsualCycles(policy.cyclesPerAction()));
        environment.reset(seed);
        double reward = 0;
        while (!environment.isOver() && !environment.isLate()) {
            environment.step(network.apply(taken(places, environment.observation())));
            reward += environment.reward();
        }
        GymTask task = environment.task();
        return LessonFigures.of(environment.cycles(), reward, task.hasFallen(), task.isDone());
    }

    private static double[] taken(int[] places, double... observation) {
        double[] taken = new double[places.length];
        for (int i = 0; i < places.length; i++) {
            taken[i] = observation[places[i]];
        }
        return taken;
    }

    private int place(Quantity input) {
        List<ObservedQuantity> all = environment.quantities();
        for (int i = 0; i < all.size(); i++) {
            if (all.get(i).name().equals(input.name()) && all.get(i).unit().equals(input.unit())) {
                return i;
            }
        }
        throw new IllegalArgumentException("The policy takes " + input.name() + " in " + input.unit()
                + ", which is not observed in " + course.task() + ".");
    }

    @Override
    public void close() {
        environment.close();
    }
}
