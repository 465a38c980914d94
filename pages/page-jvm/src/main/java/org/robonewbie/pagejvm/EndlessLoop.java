package org.robonewbie.pagejvm;

/** A program did not come to the end of a cycle. */
public final class EndlessLoop extends Error {

    private static final long serialVersionUID = 1;

    private final String place;

    EndlessLoop(String place, long steps) {
        super("Stopped at " + place + ": the program has gone " + steps
                + " steps without a new message of the simulator. Does a loop there never end?");
        this.place = place;
    }

    /** {@return where it was stopped, such as {@code Walker.java:12}} */
    public String place() {
        return place;
    }
}
