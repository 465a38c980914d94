package org.robonewbie.competition.programs;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.util.List;

/**
 * Starts processes that leave their parents, one of them without anything that it could have inherited. They sleep for as many seconds as the
 * last folder of the class path says, so that whoever started this program recognises them.
 */
public final class LeavesChildren {

    private LeavesChildren() {}

    /**
     * Starts them and the robot.
     *
     * @param args options of the robot
     */
    public static void main(String[] args) {
        String classPath = System.getProperty("java.class.path");
        String sleep = "sleep " + classPath.substring(classPath.lastIndexOf('/') + 1);
        System.out.println(sleep);
        for (String command :
                List.of("(setsid " + sleep + " &)", "cd / && (setsid " + sleep + " &)", "(" + sleep + " &)")) {
            try {
                new ProcessBuilder("sh", "-c", command).start();
            } catch (IOException unstartable) {
                throw new UncheckedIOException(unstartable);
            }
        }
        Stands.main(args);
    }
}
