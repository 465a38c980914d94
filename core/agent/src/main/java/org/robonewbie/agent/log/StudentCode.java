package org.robonewbie.agent.log;

import java.util.Arrays;
import java.util.List;
import java.util.Optional;

/** Finds the robot program's own lines among the stack frames of the framework and Java. */
public final class StudentCode {

    private static final List<String> FRAMEWORK_PREFIXES = List.of(
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
     * Finds the program line that this thread is executing.
     *
     * @return file and line, such as {@code WalkToBall.java:31}; empty if only the framework is running
     */
    public static Optional<String> place() {
        return place(new Throwable().getStackTrace());
    }

    /**
     * Finds the program line in a stack trace.
     *
     * @param trace innermost call first
     * @return file and line, such as {@code WalkToBall.java:31}; empty if only the framework was running
     */
    public static Optional<String> place(StackTraceElement[] trace) {
        return lines(trace).stream().findFirst().map(StudentCode::place);
    }

    /**
     * Returns the position of a stack frame.
     *
     * @param frame the stack frame
     * @return file and line, such as {@code WalkToBall.java:31}
     */
    public static String place(StackTraceElement frame) {
        return frame.getFileName() + ":" + frame.getLineNumber();
    }

    /**
     * Returns the stack frames of the robot's own program.
     *
     * @param trace innermost call first
     * @return its frames, in the same order
     */
    public static List<StackTraceElement> lines(StackTraceElement[] trace) {
        return Arrays.stream(trace)
                .filter(call -> isStudentCode(call.getClassName()))
                .toList();
    }

    private static boolean isStudentCode(String className) {
        for (String prefix : FRAMEWORK_PREFIXES) {
            if (className.startsWith(prefix)) {
                return false;
            }
        }
        return true;
    }
}
