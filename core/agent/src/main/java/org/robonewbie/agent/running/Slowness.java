package org.robonewbie.agent.running;

/**
 * Cause of a program's slow cycles.
 *
 * @param cause what the program is doing in these cycles, and on which line
 * @param milliseconds median duration of such a cycle
 */
public record Slowness(StackSample cause, double milliseconds) {

    /** {@return whether the program sleeps or waits instead of computing} */
    public boolean isIdle() {
        return cause.kind() != StackSample.Kind.COMPUTES;
    }

    /** {@return advice, as a sentence} */
    public String advice() {
        return switch (cause.kind()) {
            case SLEEPS -> "Count cycles or compare nao.getTime() instead.";
            case WAITS -> "Wait in a separate thread, and read only its result.";
            case COMPUTES -> "Compute less in a cycle, or spread the work over several cycles.";
        };
    }
}
