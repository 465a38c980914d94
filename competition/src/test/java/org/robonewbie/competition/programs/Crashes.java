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
        System.out.println(args[args.length]);
    }
}
