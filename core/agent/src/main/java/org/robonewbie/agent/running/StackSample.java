package org.robonewbie.agent.running;

import java.util.Arrays;
import java.util.List;
import org.robonewbie.agent.log.StudentCode;

/**
 * Activity of a thread at one moment, as shown by its stack.
 *
 * @param kind whether the thread is computing, sleeping or waiting
 * @param call the Java method in which the program is sleeping or waiting, such as {@code Scanner.nextLine()}; empty if
 *     it is computing
 * @param place the line of the robot's own program; empty if only the framework is running
 */
public record StackSample(Kind kind, String call, String place) {

    /** Kind of activity. */
    public enum Kind {

        /** The thread is computing. */
        COMPUTES,

        /** The thread is sleeping. */
        SLEEPS,

        /** The thread is waiting for input, a lock or another thread. */
        WAITS
    }

    private static final List<String> JAVA = List.of("java.", "javax.", "jdk.", "sun.");
    private static final List<String> INPUT_AND_OUTPUT = List.of("java.io.", "java.net.", "sun.nio.ch.", "sun.net.");
    private static final List<String> SLEEPING = List.of("sleep", "parkNanos", "parkUntil");

    /**
     * Classifies a thread.
     *
     * @param state its state
     * @param trace its stack, innermost call first
     * @return its activity; the framework counts as computing while it waits for the simulator
     */
    static StackSample of(Thread.State state, StackTraceElement[] trace) {
        List<StackTraceElement> above = Arrays.stream(trace)
                .takeWhile(call ->
                        StudentCode.lines(new StackTraceElement[] {call}).isEmpty())
                .toList();
        String place = StudentCode.place(trace).orElse("");
        boolean frameworkWorks = place.isEmpty() || !above.stream().allMatch(StackSample::isJava);
        if (frameworkWorks || !isWaiting(state, trace[0])) {
            return new StackSample(Kind.COMPUTES, "", place);
        }
        if (above.isEmpty()) {
            return new StackSample(Kind.WAITS, "synchronized", place);
        }
        StackTraceElement call = above.get(above.size() - 1);
        String type = call.getClassName();
        return new StackSample(
                SLEEPING.contains(call.getMethodName()) ? Kind.SLEEPS : Kind.WAITS,
                type.substring(type.lastIndexOf('.') + 1).replace('$', '.') + "." + call.getMethodName() + "()",
                place);
    }

    /**
     * Returns whether a thread is waiting. Java also reports RUNNABLE for threads that wait for input or output in the
     * operating system.
     */
    private static boolean isWaiting(Thread.State state, StackTraceElement innermost) {
        return switch (state) {
            case WAITING, TIMED_WAITING, BLOCKED -> true;
            case RUNNABLE -> innermost.isNativeMethod() && startsWithOneOf(innermost.getClassName(), INPUT_AND_OUTPUT);
            case NEW, TERMINATED -> false;
        };
    }

    private static boolean isJava(StackTraceElement call) {
        return startsWithOneOf(call.getClassName(), JAVA);
    }

    private static boolean startsWithOneOf(String name, List<String> prefixes) {
        return prefixes.stream().anyMatch(name::startsWith);
    }
}
