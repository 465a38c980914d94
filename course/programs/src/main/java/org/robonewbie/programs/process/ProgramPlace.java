package org.robonewbie.programs.process;

import java.util.Arrays;
import java.util.Optional;
import org.robonewbie.agent.log.StudentCode;

/** Where in its own code a program is that is being judged. */
public final class ProgramPlace {

    private static final String TRIALS = "org.robonewbie.trial.";

    /** The class of a judge that tries a program in its own process. */
    private static final String JUDGE = "org.robonewbie.exercises.GradedTrial";

    private ProgramPlace() {}

    /**
     * Finds the program's line in a stack trace.
     *
     * @param trace innermost call first
     * @return such as {@code WalkToBall.java:31}; empty if only framework and judge are at work
     */
    public static Optional<String> in(StackTraceElement[] trace) {
        return StudentCode.place(Arrays.stream(trace)
                .takeWhile(frame -> !isFramework(frame.getClassName()))
                .toArray(StackTraceElement[]::new));
    }

    /**
     * Describes what a program has thrown.
     *
     * @param mistake what it has thrown
     * @return the mistake, and the program's line if it is known
     */
    public static String of(Throwable mistake) {
        return mistake + in(mistake.getStackTrace()).map(line -> " in " + line).orElse("");
    }

    /** Whatever these classes call for a program is the program's own doing; what they do themselves is not. */
    private static boolean isFramework(String className) {
        return className.startsWith(TRIALS) || className.equals(JUDGE);
    }
}
