package org.robonewbie.exercises;

import java.util.Arrays;
import java.util.Optional;
import org.robonewbie.agent.log.StudentCode;
import org.robonewbie.trial.Controller;

/** Where in its own code a program is that is being judged. */
final class ProgramPlace {

    private static final String TRIALS = Controller.class.getName().replace(Controller.class.getSimpleName(), "");

    private ProgramPlace() {}

    /**
     * Finds the program's line in a stack trace.
     *
     * @param trace innermost call first
     * @return such as {@code WalkToBall.java:31}; empty if only framework and judge are at work
     */
    static Optional<String> in(StackTraceElement[] trace) {
        return StudentCode.place(Arrays.stream(trace)
                .takeWhile(frame -> !isFramework(frame.getClassName()))
                .toArray(StackTraceElement[]::new));
    }

    /** Whatever these classes call for a program is the program's own doing; what they do themselves is not. */
    private static boolean isFramework(String className) {
        return className.startsWith(TRIALS) || className.equals(GradedTrial.class.getName());
    }
}
