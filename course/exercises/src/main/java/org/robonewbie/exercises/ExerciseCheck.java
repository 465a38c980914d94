package org.robonewbie.exercises;

import java.util.function.Supplier;
import java.util.stream.Collectors;
import org.robonewbie.agent.Agent;

/**
 * Assertion for tests of solutions. Works with any test framework.
 *
 * <pre>{@code
 * @Test
 * void myKickIsGoodEnough() {
 *     ExerciseCheck.assertSolved("kick", MyKick::new);
 * }
 * }</pre>
 */
public final class ExerciseCheck {

    private static final int SEEDS = 3;

    private ExerciseCheck() {}

    /**
     * Asserts that a program solves an exercise for the seeds 1 to 3.
     *
     * @param exercise name or number of the exercise
     * @param student creates an agent that runs the student's program
     * @throws AssertionError if the program does not solve it; the message contains the grade and hints
     * @throws IllegalArgumentException if there is no such exercise
     */
    public static void assertSolved(String exercise, Supplier<? extends Agent> student) {
        Exercise found = Exercises.find(exercise).orElseThrow(() -> unknown(exercise));
        Grade grade = new Grader().grade(found, student, SEEDS);
        if (!grade.passed()) {
            throw new AssertionError(System.lineSeparator() + grade);
        }
    }

    private static IllegalArgumentException unknown(String name) {
        return new IllegalArgumentException("There is no exercise \"" + name + "\". The exercises are: "
                + Exercises.all().stream().map(Exercise::name).collect(Collectors.joining(", ")));
    }
}
