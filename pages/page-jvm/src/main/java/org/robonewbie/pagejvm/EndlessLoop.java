package org.robonewbie.pagejvm;

/** Thrown when a program does not finish a cycle within the instruction limit. */
public final class EndlessLoop extends Error {

    private static final long serialVersionUID = 1;

    private final String place;

    EndlessLoop(String place, long steps) {
        super("Stopped at " + place + ": the program has executed " + steps
                + " instructions without a new message from the simulator. Is there an infinite loop?");
        this.place = place;
    }

    /** {@return the position at which the program was stopped, for example {@code Walker.java:12}} */
    public String place() {
        return place;
    }
}
