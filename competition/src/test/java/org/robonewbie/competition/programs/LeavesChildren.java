package org.robonewbie.competition.programs;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.util.List;

/** Starts processes that leave their parents, one of them without anything that it could have inherited. */
public final class LeavesChildren {

    /** What they do; nobody else sleeps so long. */
    public static final String SLEEP = "sleep 78787";

    private LeavesChildren() {}

    /**
     * Starts them and the robot.
     *
     * @param args options of the robot
     */
    public static void main(String[] args) {
        for (String command :
                List.of("(setsid " + SLEEP + " &)", "cd / && (setsid " + SLEEP + " &)", "(" + SLEEP + " &)")) {
            try {
                new ProcessBuilder("sh", "-c", command).start();
            } catch (IOException unstartable) {
                throw new UncheckedIOException(unstartable);
            }
        }
        Stands.main(args);
    }
}
