package org.robonewbie.competition.programs;

/** Prints a hundred megabytes in one line and then plays. */
public final class PrintsMuch {

    private PrintsMuch() {}

    /**
     * Prints, then starts the robot.
     *
     * @param args options of the robot
     */
    public static void main(String[] args) {
        String megabyte = "x".repeat(1_000_000);
        for (int i = 0; i < 100; i++) {
            System.out.print(megabyte);
        }
        Stands.main(args);
    }
}
