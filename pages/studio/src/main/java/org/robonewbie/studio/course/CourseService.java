package org.robonewbie.studio.course;

import java.io.IOException;
import java.util.List;

/** The exercises of the studio and the current attempt. Thread-safe. */
public interface CourseService {

    /** {@return all exercises in course order} */
    List<Lesson> lessons();

    /** {@return two-letter code of the language of titles, goals, worksheets, findings and hints} */
    String language();

    /**
     * Sets the language.
     *
     * @param code two-letter code
     * @throws IllegalArgumentException if the language is not available
     */
    void speak(String code);

    /** {@return Java files in the working directory that could solve an exercise} */
    List<String> programs();

    /**
     * Writes the starter program of an exercise into the working directory.
     *
     * @param exercise name of an exercise
     * @return name of the file
     * @throws IOException if the file cannot be written
     * @throws IllegalArgumentException if the file exists or the exercise does not
     */
    String handOut(String exercise) throws IOException;

    /**
     * Starts an attempt on the displayed pitch and ends the previous one.
     *
     * @param exercise name of an exercise
     * @param program a Java file or class; empty for an agent that the student starts
     * @param trials number of trials with different seeds, 1 to 20
     * @throws IOException if no port is available for the program
     * @throws IllegalArgumentException if there is no such exercise
     */
    void begin(String exercise, String program, int trials) throws IOException;

    /** Ends the attempt and shows the free pitch. */
    void leave();

    /** {@return the state of the current attempt} */
    Attempt attempt();

    /** {@return the student's progress in the whole course} */
    Standings standings();

    /**
     * Returns the hints that the student has opened.
     *
     * @param exercise name of an exercise
     * @return the opened hints
     * @throws IllegalArgumentException if there is no such exercise
     */
    Help help(String exercise);

    /**
     * Opens the next hint.
     *
     * @param exercise name of an exercise
     * @return the opened hints
     * @throws IllegalArgumentException if there is no such exercise
     */
    Help nextHint(String exercise);

    /**
     * Returns the sample solution.
     *
     * @param exercise name of an exercise
     * @return source code of the solution
     * @throws IllegalArgumentException if the solution is locked or missing; the message gives the reason
     */
    String solution(String exercise);
}
