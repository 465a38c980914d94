package org.robonewbie.studio.course;

import java.util.List;
import java.util.function.UnaryOperator;

/**
 * Progress of a student's program on an exercise.
 *
 * @param id number of the attempt, 0 before the first one
 * @param state current stage
 * @param exercise name of the exercise
 * @param program the program under test; empty for an agent that the student starts
 * @param port TCP port at which the student's agent is expected
 * @param trials planned number of trials
 * @param judged results of the finished trials
 * @param points mean of the points, 0 to 10
 * @param passed whether all trials were passed
 * @param output the latest output of the program, for debugging
 */
public record Attempt(
        long id,
        State state,
        String exercise,
        String program,
        int port,
        int trials,
        List<Judged> judged,
        double points,
        boolean passed,
        String output) {

    /** The stages of an attempt. */
    public enum State {
        /** No trial is running. */
        NONE,
        /** The program has not joined yet. */
        WAITING,
        /** A trial is running. */
        RUNNING,
        /** All trials have been judged. */
        OVER
    }

    /**
     * Result of one trial.
     *
     * @param seed random seed of the trial
     * @param passed whether the task was solved
     * @param points 0 to 10
     * @param finding the measurement as a sentence
     * @param hint what to try next; may be empty
     */
    public record Judged(long seed, boolean passed, int points, String finding, String hint) {}

    /** The state before the first attempt. */
    public static final Attempt NONE = new Attempt(0, State.NONE, "", "", 0, 0, List.of(), 0, false, "");

    /** Defensively copies the list. */
    public Attempt {
        judged = List.copyOf(judged);
    }

    /**
     * Translates findings and hints.
     *
     * @param words translates a sentence
     * @return a translated copy
     */
    public Attempt inWords(UnaryOperator<String> words) {
        List<Judged> translated = judged.stream()
                .map(trial -> new Judged(
                        trial.seed(),
                        trial.passed(),
                        trial.points(),
                        words.apply(trial.finding()),
                        words.apply(trial.hint())))
                .toList();
        return new Attempt(id, state, exercise, program, port, trials, translated, points, passed, output);
    }
}
