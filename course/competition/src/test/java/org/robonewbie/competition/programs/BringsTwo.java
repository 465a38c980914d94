package org.robonewbie.competition.programs;

import org.robonewbie.agent.Nao;

/** Wants two robots at the same time, and stands still with those that it gets. */
public final class BringsTwo {

    private BringsTwo() {}

    /**
     * Starts the robots.
     *
     * @param args their options
     */
    public static void main(String[] args) {
        new Thread(() -> stand(args)).start();
        stand(args);
    }

    private static void stand(String[] args) {
        try (Nao nao = Nao.connect(args)) {
            while (nao.sense()) {
                nao.act();
            }
        }
    }
}
