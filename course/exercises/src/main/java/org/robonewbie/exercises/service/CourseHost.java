package org.robonewbie.exercises.service;

import java.io.IOException;
import java.util.List;
import java.util.function.Consumer;
import org.robonewbie.exercises.Exercise;
import org.robonewbie.exercises.Grade;

/** Programs and pitch of a student for the {@link CourseService}. */
public interface CourseHost {

    /** Trials of one exercise with consecutive seeds, shown to the student. */
    interface Attempt extends AutoCloseable {

        /** {@return the current status} */
        Status status();

        /** Ends the attempt in any state. */
        @Override
        void close();
    }

    /** Stages of an attempt. */
    enum State {
        /** The program has not joined yet. */
        WAITING,
        /** A trial is running. */
        RUNNING,
        /** All trials have been judged. */
        OVER
    }

    /**
     * Status of an attempt.
     *
     * @param state current stage
     * @param port TCP port at which the student's agent is expected; 0 for none
     * @param grade scores of the finished trials
     * @param output the latest output of the program, for debugging
     */
    record Status(State state, int port, Grade grade, String output) {}

    /** {@return saved Java files that could solve an exercise} */
    List<String> programs();

    /**
     * Creates a program unless a file of this name exists.
     *
     * @param file name of the new file
     * @param text its content
     * @return whether it was created
     * @throws IOException if it cannot be written
     */
    boolean create(String file, String text) throws IOException;

    /**
     * Starts an attempt on the displayed pitch and ends the previous one.
     *
     * @param exercise the exercise
     * @param id number of the attempt
     * @param program a Java file or class; empty for an agent that the student starts
     * @param trials number of trials
     * @param judged receives the grade when all trials have been judged
     * @return the attempt
     * @throws IOException if no port is available for the program
     * @throws IllegalArgumentException if the program cannot be judged here; the message gives the reason
     */
    Attempt begin(Exercise exercise, long id, String program, int trials, Consumer<Grade> judged) throws IOException;

    /** Shows the pitch without an exercise. */
    void showFreePitch();
}
