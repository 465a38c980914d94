package org.robonewbie.agent.running;

/**
 * What makes a program slow, cycle after cycle.
 *
 * @param cause what it does meanwhile, with the line
 * @param milliseconds how long such a cycle takes, the median
 */
public record Slowness(StackSample cause, double milliseconds) {

    /** {@return whether the program lets time pass without using it} */
    public boolean isIdle() {
        return cause.kind() != StackSample.Kind.COMPUTES;
    }

    /** {@return what to do instead, as a sentence} */
    public String advice() {
        return switch (cause.kind()) {
            case SLEEPS -> "Count cycles or compare nao.getTime() instead.";
            case WAITS -> "Let a thread of its own wait, and look only at what it has found.";
            case COMPUTES -> "Compute less in a cycle, or spread the work over several cycles.";
        };
    }
}
