package org.robonewbie.app;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;

/** How {@code robonewbie grade} is started in a process of its own with this Java and these classes, for a student's program. */
final class StudentJava {

    /** Memory of the process. */
    static final int MEGABYTES = 512;

    private StudentJava() {}

    static List<String> grade(List<String> javaOptions, List<String> arguments) {
        List<String> command = new ArrayList<>(List.of(
                Path.of(System.getProperty("java.home"), "bin", "java").toString(),
                "-XX:+UseSerialGC",
                "-Xmx" + MEGABYTES + "m",
                "-XX:+ExitOnOutOfMemoryError"));
        command.addAll(javaOptions);
        command.addAll(List.of("-cp", System.getProperty("java.class.path"), Main.class.getName(), GradeCommand.NAME));
        command.addAll(arguments);
        return command;
    }
}
