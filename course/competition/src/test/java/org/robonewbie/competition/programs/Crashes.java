package org.robonewbie.competition.programs;

import org.robonewbie.agent.Nao;

/** A program without the framework's cycle: an exception in the middle of the game ends it. */
public final class Crashes {

    private static final double GOOD_SECONDS = 2;

    private Crashes() {}

    /**
     * Fails.
     *
     * @param args its options
     */
    public static void main(String[] args) {
        try (Nao nao = Nao.connect(args)) {
            while (nao.sense()) {
                if (nao.getTime() > GOOD_SECONDS) {
                    System.out.println(args[args.length]);
                }
                nao.act();
            }
        }
    }
}
