package org.robonewbie.web.library.org.robonewbie.agent.log;

import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import org.robonewbie.web.PageMemory;

/**
 * Finds the current line of the robot's program. The program is interpreted, so the JVM's stack trace does not contain it.
 */
public final class PageStudentCode {

    private static final String FRAMEWORK = "org.robonewbie.agent.";

    private PageStudentCode() {}

    /**
     * Finds the current line.
     *
     * @return a position such as {@code WalkToBall.java:31}; empty if only the framework is running
     */
    public static Optional<String> place() {
        return place(PageMemory.calls());
    }

    /**
     * Finds the line in a stack trace.
     *
     * @param trace the stack trace, innermost call first
     * @return a position such as {@code WalkToBall.java:31}; empty if only the framework is running
     */
    public static Optional<String> place(StackTraceElement[] trace) {
        return lines(trace).stream().findFirst().map(PageStudentCode::place);
    }

    /**
     * Returns the stack frames of the robot's own program.
     *
     * @param trace the stack trace, innermost call first
     * @return the program's frames, in the same order
     */
    public static List<StackTraceElement> lines(StackTraceElement[] trace) {
        return Arrays.stream(trace)
                .filter(call -> call.getFileName() != null && call.getLineNumber() > 0)
                .filter(call -> !call.getClassName().startsWith(FRAMEWORK))
                .toList();
    }

    /**
     * Returns the position of a stack frame.
     *
     * @param call the stack frame
     * @return a position such as {@code WalkToBall.java:31}
     */
    public static String place(StackTraceElement call) {
        return call.getFileName() + ":" + call.getLineNumber();
    }
}
