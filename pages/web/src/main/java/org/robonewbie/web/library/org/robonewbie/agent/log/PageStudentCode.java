package org.robonewbie.web.library.org.robonewbie.agent.log;

import java.util.Arrays;
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
        return Arrays.stream(trace)
                .filter(call -> call.getFileName() != null && call.getLineNumber() > 0)
                .filter(call -> !call.getClassName().startsWith(FRAMEWORK))
                .findFirst()
                .map(call -> call.getFileName() + ":" + call.getLineNumber());
    }
}
