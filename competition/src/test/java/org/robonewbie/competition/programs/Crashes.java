package org.robonewbie.competition.programs;

/** Ends with an exception before it has done anything. */
public final class Crashes {

    private Crashes() {}

    /**
     * Fails.
     *
     * @param args without meaning
     */
    public static void main(String[] args) {
        throw new IllegalStateException("this program is broken");
    }
}
