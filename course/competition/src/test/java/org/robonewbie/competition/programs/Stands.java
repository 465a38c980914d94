package org.robonewbie.competition.programs;

import org.robonewbie.agent.Nao;

/** An honest program that does nothing. */
public final class Stands {

    private Stands() {}

    /**
     * Brings a robot.
     *
     * @param args its options
     */
    public static void main(String[] args) {
        try (Nao nao = Nao.connect(args)) {
            while (nao.sense()) {
                nao.act();
            }
        }
    }

    /** Brings a robot beside whatever else a program does. */
    static void beside(String[] args, Runnable work) {
        Thread thread = new Thread(work, "beside");
        thread.setDaemon(true);
        thread.start();
        main(args);
    }
}
