package org.robonewbie.competition.programs;

import java.io.IOException;

/** Starts one process after the other, until it is stopped; the number only protects the computer. */
public final class StartsCrowd {

    private static final int MAX_PROCESSES = 3000;

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
            for (int i = 0; i < MAX_PROCESSES; i++) {
                new ProcessBuilder("sleep", "60").start();
            }
        } catch (IOException refused) {
            System.out.println("no more processes");
        }
    }
}
