package org.robonewbie.learning.optimise;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;

/**
 * Something that can be improved by changing numbers. Each number is a coordinate: how far it is from where it is now, in steps
 * that are noticeable but small. So all coordinates begin at 0. Used by several threads at once.
 */
public interface Subject {

    /**
     * Names the subject as on the command line.
     *
     * @return such as {@code kick-right} or {@code my-walk.txt}
     */
    String name();

    /**
     * Says what stands on the command line for this subject.
     *
     * @return the words between {@code optimise} and {@code --objective}; the name if nothing else is needed
     */
    default String words() {
        return name();
    }

    /**
     * Tells how many numbers there are.
     *
     * @return number of coordinates, at least 1
     */
    int dimension();

    /**
     * Explains a candidate to people.
     *
     * @param coordinates how far each number is changed
     * @return its numbers, in the order of the coordinates
     */
    List<SubjectNumber> numbers(double[] coordinates);

    /**
     * Identifies the present state, so that a search is not continued with something else.
     *
     * @return the same text as long as nothing changes
     */
    String fingerprint();

    /**
     * Tries a candidate.
     *
     * @param coordinates how far each number is changed
     * @param seed chooses the circumstances; the same seed gives the same result
     * @return what came out
     */
    Attempt attempt(double[] coordinates, long seed);

    /**
     * Says what else people can do with a candidate than to use its file.
     *
     * @param coordinates how far each number is changed
     * @return some lines, or nothing
     */
    default String advice(double[] coordinates) {
        return "";
    }

    /**
     * Writes a candidate to a file, all at once or not at all.
     *
     * @param coordinates how far each number is changed
     * @param facts what the file says about how it was made, in this order
     * @param file where it goes
     * @throws IOException if the file cannot be written
     */
    void save(double[] coordinates, Map<String, String> facts, Path file) throws IOException;
}
