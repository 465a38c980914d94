package org.robonewbie.studio.course;

import java.util.List;
import java.util.function.UnaryOperator;

/**
 * How far a student's program is with an exercise.
 *
 * @param id number of the attempt, 0 if nothing was tried yet
 * @param state where it is
 * @param exercise name of the exercise
 * @param program what solves it; empty for an agent that the student starts
 * @param port where the student's agent is awaited
 * @param trials how many trials there will be
 * @param judged what the trials that are over have earned
 * @param points mean of the points, 0 to 10
 * @param passed whether all trials have passed
 * @param output what the program has printed last, for those who look for a mistake
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
        /** The program has not joined the pitch yet. */
        WAITING,
        /** A trial is running. */
        RUNNING,
        /** All trials are judged. */
        OVER
    }

    /**
     * One trial that is over.
     *
     * @param seed what it began with
     * @param passed whether the task was solved
     * @param points 0 to 10
     * @param finding what was measured
     * @param hint what to try next; empty if there is nothing to add
     */
    public record Judged(long seed, boolean passed, int points, String finding, String hint) {}

    /** The state before the first attempt. */
    public static final Attempt NONE = new Attempt(0, State.NONE, "", "", 0, 0, List.of(), 0, false, "");

    /** Takes a copy. */
    public Attempt {
        judged = List.copyOf(judged);
    }

    /**
     * Writes findings and hints in other words.
     *
     * @param words what to write in the place of a sentence
     * @return the same attempt with these sentences
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
