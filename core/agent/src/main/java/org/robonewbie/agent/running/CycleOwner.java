package org.robonewbie.agent.running;

import java.util.Locale;

/**
 * The owner of the cycle, either the framework or the program itself; determines the wording of reports about slow
 * programs.
 */
public enum CycleOwner {

    /** The framework, which calls {@code think()}. */
    FRAMEWORK("think()", "think() has not returned", "it is called"),

    /** The program itself, which calls {@code sense()} and {@code act()}. */
    PROGRAM("The program", "The program has not called sense()", "sense() must be called");

    private final String subject;
    private final String stall;
    private final String rhythm;

    CycleOwner(String subject, String stall, String rhythm) {
        this.subject = subject;
        this.stall = stall;
        this.rhythm = rhythm;
    }

    /** Describes a program that has stalled. */
    String stall(String howLong) {
        return stall + " for " + howLong + ". Is this an infinite loop, or is the program waiting for something?";
    }

    /**
     * Describes a slow program.
     *
     * @param slowness cause of the slow cycles
     * @param place the line, such as {@code " at Walker.java:9"}; empty if the line is reported elsewhere
     * @return a sentence
     */
    public String finding(Slowness slowness, String place) {
        String time = String.format(Locale.ROOT, "%.0f ms", slowness.milliseconds());
        String does = switch (slowness.cause().kind()) {
            case SLEEPS -> " slept " + time;
            case WAITS -> " waited " + time + " in " + slowness.cause().call();
            case COMPUTES -> " took about " + time;
        };
        return subject + does + place + "; " + rhythm + " 50 times per simulated second.";
    }
}
