package org.robonewbie.app.program;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;

/**
 * The command line that runs {@code robonewbie grade} in a separate process with this Java and these classes, for a student's
 * program.
 */
public final class StudentJava {

    /** Memory of the process, in megabytes. */
    public static final int MEGABYTES = 512;

    /** The command that runs or grades the program. */
    public static final String COMMAND = "grade";

    /** Its option for a program that comes to a trial through a port. */
    public static final String AT_DOOR = "--at-door";

    private static final String MAIN = "org.robonewbie.app.Main";

    private StudentJava() {}

    /**
     * Returns the command line of the process.
     *
     * @param javaOptions options of this Java
     * @param arguments what follows the command
     * @return program and arguments
     */
    public static List<String> grade(List<String> javaOptions, List<String> arguments) {
        List<String> command = new ArrayList<>(List.of(
                Path.of(System.getProperty("java.home"), "bin", "java").toString(),
                "-XX:+UseSerialGC",
                "-Xmx" + MEGABYTES + "m",
                "-XX:+ExitOnOutOfMemoryError"));
        command.addAll(javaOptions);
        command.addAll(List.of("-cp", System.getProperty("java.class.path"), MAIN, COMMAND));
        command.addAll(arguments);
        return command;
    }
}
