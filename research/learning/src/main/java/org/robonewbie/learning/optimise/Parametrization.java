package org.robonewbie.learning.optimise;

import java.io.IOException;
import java.io.Serializable;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;

/**
 * The parameters of a motion, of the walk engine or of a program, as coordinates of a search. A coordinate is the distance from the present
 * value in noticeable but small steps, so all coordinates start at 0. Thread-safe.
 */
public interface Parametrization {

    /** {@return the name on the command line, such as {@code kick-right} or {@code my-walk.txt}} */
    String name();

    /**
     * {@return the words between {@code optimise} and {@code --objective} on the command line; the name if nothing else is
     * needed}
     */
    default String words() {
        return name();
    }

    /** {@return the number of coordinates, at least 1} */
    int dimension();

    /**
     * Describes a candidate.
     *
     * @param coordinates how far each number is changed
     * @return its numbers, in the order of the coordinates
     */
    List<Parameter> numbers(double[] coordinates);

    /**
     * Identifies the present values, so that a search is not resumed with others.
     *
     * @return the same text as long as nothing changes
     */
    String fingerprint();

    /**
     * Evaluates a candidate.
     *
     * @param coordinates how far each number is changed
     * @param seed chooses all that is random; the same seed gives the same result
     * @return the result
     */
    Evaluation evaluate(double[] coordinates, long seed);

    /** Creates the same parametrization on another computer. */
    @FunctionalInterface
    interface Recipe extends Serializable {

        /**
         * Creates the parametrization.
         *
         * @param classes knows the classes of programs and measures
         * @return the parametrization
         * @throws IllegalArgumentException if a class is missing; the message names it
         */
        Parametrization create(ClassLoader classes);
    }

    /**
     * Returns what another computer needs to evaluate the same candidates.
     *
     * @return the recipe
     * @throws IllegalArgumentException if candidates can be evaluated in this program only
     */
    default Recipe recipe() {
        throw new IllegalArgumentException(name() + " can be tried in this program only; use the engine local.");
    }

    /**
     * Returns how else a candidate can be used than by its file.
     *
     * @param coordinates how far each number is changed
     * @return some lines, possibly none
     */
    default String advice(double[] coordinates) {
        return "";
    }

    /**
     * Writes a candidate to a file, atomically.
     *
     * @param coordinates how far each number is changed
     * @param facts what the file records about how it was made, in this order
     * @param file where it goes
     * @throws IOException if the file cannot be written
     */
    void save(double[] coordinates, Map<String, String> facts, Path file) throws IOException;
}
