package org.robonewbie.agent.log;

import java.util.Arrays;
import java.util.List;
import java.util.Optional;

/** Finds the line of the robot's own program among those of the framework and of Java. */
public final class StudentCode {

    private static final List<String> NOT_THEIRS = List.of(
            "org.robonewbie.agent.",
            "org.robonewbie.nao.",
            "org.robonewbie.protocol.",
            "org.robonewbie.simulator.",
            "org.robonewbie.learning.",
            "org.robonewbie.app.",
            "org.robonewbie.programs.",
            "picocli.",
            "org.junit.",
            "java.",
            "javax.",
            "jdk.",
            "sun.");

    private StudentCode() {}

    /**
     * Finds the line that is being executed by this thread.
     *
     * @return such as {@code WalkToBall.java:31}; empty if only the framework is at work
     */
    public static Optional<String> place() {
        return place(new Throwable().getStackTrace());
    }

    /**
     * Finds the line in a stack trace.
     *
     * @param trace innermost call first
     * @return such as {@code WalkToBall.java:31}; empty if only the framework is at work
     */
    public static Optional<String> place(StackTraceElement[] trace) {
        return Arrays.stream(trace)
                .filter(frame -> isTheirs(frame.getClassName()))
                .findFirst()
                .map(frame -> frame.getFileName() + ":" + frame.getLineNumber());
    }

    /**
     * Keeps the calls of the robot's own program.
     *
     * @param trace innermost call first
     * @return its calls, in the same order
     */
    public static List<StackTraceElement> lines(StackTraceElement[] trace) {
        return Arrays.stream(trace)
                .filter(call -> isTheirs(call.getClassName()))
                .toList();
    }

    private static boolean isTheirs(String className) {
        for (String prefix : NOT_THEIRS) {
            if (className.startsWith(prefix)) {
                return false;
            }
        }
        return true;
    }
}
