package org.robonewbie.studio.course;

import java.io.IOException;
import java.util.List;

/** The exercises behind the page, and the one that is being tried. Any thread may ask. */
public interface Course {

    /** {@return all exercises, in the order of the course} */
    List<Lesson> lessons();

    /** {@return the language of titles, goals, worksheets, findings and hints, as two letters} */
    String language();

    /**
     * Chooses the language.
     *
     * @param code two letters
     * @throws IllegalArgumentException if there is no such language; the message says so
     */
    void speak(String code);

    /** {@return programs that could solve an exercise: Java files of the working directory} */
    List<String> programs();

    /**
     * Writes the program to begin with into the working directory.
     *
     * @param exercise name of an exercise
     * @return name of the written file
     * @throws IOException if it cannot be written
     * @throws IllegalArgumentException if it is there already, or there is no such exercise; the message says so
     */
    String handOut(String exercise) throws IOException;

    /**
     * Begins to try a program, on the pitch that the page shows; what was tried before ends.
     *
     * @param exercise name of an exercise
     * @param program a Java file or class; empty for an agent that the student starts
     * @param trials how many trials with different seeds, 1 to 20
     * @throws IOException if there is no port for the program
     * @throws IllegalArgumentException if there is no such exercise; the message says so
     */
    void begin(String exercise, String program, int trials) throws IOException;

    /** Ends what is being tried, and shows the free pitch again. */
    void leave();

    /** {@return the present state of the trials} */
    Attempt attempt();

    /** {@return how far the student is with all exercises} */
    Standings standings();

    /**
     * Returns the help that is open.
     *
     * @param exercise name of an exercise
     * @return the help
     * @throws IllegalArgumentException if there is no such exercise; the message says so
     */
    Help help(String exercise);

    /**
     * Opens the next hint.
     *
     * @param exercise name of an exercise
     * @return the help that is open now
     * @throws IllegalArgumentException if there is no such exercise; the message says so
     */
    Help nextHint(String exercise);

    /**
     * Shows a solution.
     *
     * @param exercise name of an exercise
     * @return the program
     * @throws IllegalArgumentException if it is not shown; the message says why
     */
    String solution(String exercise);
}
