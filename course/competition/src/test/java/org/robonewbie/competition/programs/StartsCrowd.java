package org.robonewbie.competition.programs;

import java.io.IOException;

/** Starts one process after the other. */
public final class StartsCrowd {

    private static final int PROCESSES = 400;

    private StartsCrowd() {}

    /**
     * Starts them, then the robot.
     *
     * @param args options of the robot
     */
    public static void main(String[] args) {
        crowd();
        Stands.main(args);
    }

    private static void crowd() {
        try {
            for (int i = 0; i < PROCESSES; i++) {
                new ProcessBuilder("sleep", "60").start();
            }
        } catch (IOException refused) {
            System.out.println("no more processes");
        }
    }
}
