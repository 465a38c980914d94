package org.robonewbie.learning.optimise;

import java.io.IOException;
import java.io.Serializable;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;

/**
 * Mapping between the parameters of a motion, the walk engine or an agent and the coordinates of a search. A coordinate is the difference
 * from the current value, in steps that have a small but noticeable effect; the search starts at the origin. Implementations are
 * thread-safe.
 */
public interface Parametrization {

    /** {@return the name on the command line, such as {@code kick-right} or {@code my-walk.txt}} */
    String name();

    /** {@return the arguments between {@code optimise} and {@code --objective} on the command line, by default the name} */
    default String commandLine() {
        return name();
    }

    /** {@return the number of coordinates, at least 1} */
    int dimension();

    /**
     * Describes a candidate.
     *
     * @param coordinates the coordinates of the candidate
     * @return its parameters, in the order of the coordinates
     */
    List<Parameter> numbers(double[] coordinates);

    /** {@return a hash of the current values; a search is not resumed if they have changed} */
    String fingerprint();

    /**
     * Evaluates a candidate.
     *
     * @param coordinates the coordinates of the candidate
     * @param seed the seed of the trial; the same seed produces the same result
     * @return the result
     */
    Evaluation evaluate(double[] coordinates, long seed);

    /** Serializable factory for a parametrization, sent to the workers of a cluster. */
    @FunctionalInterface
    interface Recipe extends Serializable {

        /**
         * Creates the parametrization.
         *
         * @param classes the class loader for agents and measures
         * @return the parametrization
         * @throws IllegalArgumentException if a class is missing; the message contains its name
         */
        Parametrization create(ClassLoader classes);
    }

    /**
     * Returns a factory that creates this parametrization on another computer.
     *
     * @return the factory
     * @throws IllegalArgumentException if candidates can be evaluated only in this process
     */
    default Recipe recipe() {
        throw new IllegalArgumentException(name() + " can be evaluated in this process only. Use --engine local.");
    }

    /**
     * Describes how to use a candidate without its file.
     *
     * @param coordinates the coordinates of the candidate
     * @return lines of text; empty, the default, for none
     */
    default String advice(double[] coordinates) {
        return "";
    }

    /**
     * Atomically writes a candidate to a file.
     *
     * @param coordinates the coordinates of the candidate
     * @param facts comments about the origin of the candidate, written in this order
     * @param file the file
     * @throws IOException if the file cannot be written
     */
    void save(double[] coordinates, Map<String, String> facts, Path file) throws IOException;
}
