package org.robonewbie.exercises.service;

import java.io.IOException;
import java.util.List;
import java.util.function.Consumer;
import org.robonewbie.exercises.Exercise;
import org.robonewbie.exercises.Grade;

/** Gives the {@link CourseService} access to a student's programs and to the displayed pitch. */
public interface CourseHost {

    /** Series of trials of one exercise with consecutive seeds, which the student can watch. */
    interface Attempt extends AutoCloseable {

        /** {@return the current status} */
        Status status();

        /** Ends the attempt, regardless of its state. */
        @Override
        void close();
    }

    /** Stages of an attempt. */
    enum State {
        /** The program has not joined yet. */
        WAITING,
        /** A trial is running. */
        RUNNING,
        /** All trials have been graded. */
        OVER
    }

    /**
     * Status of an attempt.
     *
     * @param state current stage
     * @param port TCP port on which the student's agent is expected; 0 for none
     * @param grade scores of the finished trials
     * @param output the latest output of the program, for debugging
     */
    record Status(State state, int port, Grade grade, String output) {}

    /** {@return whether an agent started by the student can be graded} */
    default boolean acceptsAgents() {
        return true;
    }

    /** {@return the saved Java files that may be solutions to an exercise} */
    List<String> programs();

    /**
     * Creates a program unless a file with this name exists.
     *
     * @param file name of the new file
     * @param text contents of the file
     * @return whether it was created
     * @throws IOException if it cannot be written
     */
    boolean create(String file, String text) throws IOException;

    /**
     * Starts an attempt on the displayed pitch and ends the previous one.
     *
     * @param exercise the exercise
     * @param id number of the attempt
     * @param program a Java file or class; empty for an agent started by the student
     * @param trials number of trials
     * @param judged receives the grade once all trials have been graded
     * @return the attempt
     * @throws IOException if no port is available for the program
     * @throws IllegalArgumentException if the program cannot be graded here; the message gives the reason
     */
    Attempt begin(Exercise exercise, long id, String program, int trials, Consumer<Grade> judged) throws IOException;

    /** Shows the pitch without an exercise. */
    void showFreePitch();
}
