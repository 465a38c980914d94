package org.robonewbie.web.library.org.robonewbie.agent.log;

import java.util.Arrays;
import java.util.Optional;
import org.robonewbie.web.PageMemory;

/**
 * Finds the line of the robot's own program, which a machine carries out here: the calls of the compiled program say nothing about it.
 */
public final class PageStudentCode {

    private static final String FRAMEWORK = "org.robonewbie.agent.";

    private PageStudentCode() {}

    /**
     * Finds the line that is being executed.
     *
     * @return such as {@code WalkToBall.java:31}; empty if only the framework is at work
     */
    public static Optional<String> place() {
        return place(PageMemory.calls());
    }

    /**
     * Finds the line in a stack trace.
     *
     * @param trace innermost call first
     * @return such as {@code WalkToBall.java:31}; empty if only the framework is at work
     */
    public static Optional<String> place(StackTraceElement[] trace) {
        return Arrays.stream(trace)
                .filter(call -> call.getFileName() != null && call.getLineNumber() > 0)
                .filter(call -> !call.getClassName().startsWith(FRAMEWORK))
                .findFirst()
                .map(call -> call.getFileName() + ":" + call.getLineNumber());
    }
}
