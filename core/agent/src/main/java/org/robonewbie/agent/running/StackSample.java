package org.robonewbie.agent.running;

import java.util.Arrays;
import java.util.List;
import org.robonewbie.agent.log.StudentCode;

/**
 * What a thread was doing at one moment, as its stack shows.
 *
 * @param kind whether it computes, sleeps, or waits for something else
 * @param call the method of Java that the program has called to wait, such as {@code Scanner.nextLine()}; empty if it computes
 * @param place the line of the robot's own program; empty if only the framework is at work
 */
public record StackSample(Kind kind, String call, String place) {

    /** What takes the time. */
    public enum Kind {

        /** It works. */
        COMPUTES,

        /** It lets time pass. */
        SLEEPS,

        /** It waits for input, a lock, or another thread. */
        WAITS
    }

    private static final List<String> JAVA = List.of("java.", "javax.", "jdk.", "sun.");
    private static final List<String> INPUT_AND_OUTPUT = List.of("java.io.", "java.net.", "sun.nio.ch.", "sun.net.");
    private static final List<String> SLEEPING = List.of("sleep", "parkNanos", "parkUntil");

    /**
     * Looks at a thread.
     *
     * @param state its state
     * @param trace its stack, innermost call first
     * @return what it does; a framework that waits for the simulator computes
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

    /** Java calls a thread that waits in the operating system for input or output runnable. */
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
