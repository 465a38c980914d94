package org.robonewbie.exercises;

import java.util.function.Supplier;
import org.robonewbie.agent.Agent;

/** Finds the reference solution of an exercise. */
final class Solutions {

    private Solutions() {}

    static Supplier<Agent> of(Exercise exercise) {
        return () -> agent("org.robonewbie.exercises.solution." + exercise.className());
    }

    private static Agent agent(String className) {
        try {
            return (Agent) Class.forName(className).getConstructor().newInstance();
        } catch (ReflectiveOperationException none) {
            throw new IllegalStateException(none);
        }
    }

    /** Shows how solutions do: names of exercises and the number of seeds. */
    public static void main(String[] args) {
        int seeds = Integer.parseInt(args[args.length - 1]);
        for (Exercise exercise : Exercises.all()) {
            if (args.length == 1 || java.util.List.of(args).contains(exercise.name())) {
                long start = System.nanoTime();
                Grade grade = new Grader(1).grade(exercise, of(exercise), seeds);
                System.out.printf("%s%.1f s%n", grade, (System.nanoTime() - start) / 1e9);
            }
        }
    }
}
