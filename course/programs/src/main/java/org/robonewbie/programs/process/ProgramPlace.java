package org.robonewbie.programs.process;

import java.util.Arrays;
import java.util.Optional;
import org.robonewbie.agent.log.StudentCode;

/** Finds the line of a student's own code that is being executed. */
public final class ProgramPlace {

    private static final String TRIALS = "org.robonewbie.trial.";

    /** Name of the class that grades a program in the grader's own process. */
    private static final String JUDGE = "org.robonewbie.exercises.Grader";

    private ProgramPlace() {}

    /**
     * Finds the program's line in a stack trace.
     *
     * @param trace the stack trace, innermost call first
     * @return the line, such as {@code WalkToBall.java:31}; empty if no code of the program is active
     */
    public static Optional<String> in(StackTraceElement[] trace) {
        return StudentCode.place(Arrays.stream(trace)
                .takeWhile(frame -> !isFramework(frame.getClassName()))
                .toArray(StackTraceElement[]::new));
    }

    /**
     * Describes an exception.
     *
     * @param mistake the exception
     * @return the exception's class and message, with the program's line if it is known
     */
    public static String of(Throwable mistake) {
        return mistake + in(mistake.getStackTrace()).map(line -> " in " + line).orElse("");
    }

    /** Returns whether a stack frame belongs to the framework code that calls the program. */
    private static boolean isFramework(String className) {
        return className.startsWith(TRIALS) || className.equals(JUDGE);
    }
}
