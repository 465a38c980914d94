package org.robonewbie.app.program;

import java.lang.management.ManagementFactory;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.Stream;
import org.robonewbie.competition.team.ClassPath;

/**
 * The command lines that run {@code robonewbie grade} and {@code robonewbie run} in a separate process with this Java and these
 * classes, for a student's program.
 */
public final class StudentJava {

    /** Memory of the process, in megabytes. */
    public static final int MEGABYTES = 512;

    /** The command that runs or grades the program. */
    public static final String COMMAND = "grade";

    /** Its option for a program that comes to a trial through a port. */
    public static final String AT_DOOR = "--at-door";

    /** Its option for a program that brings robots when a judge asks for them. */
    public static final String ON_CALL = "--on-call";

    /** Programs of students compute little; so Java need not spend time on making them fast. */
    public static final String QUICK_START = "-XX:TieredStopAtLevel=1";

    /** No process can load code into this Java from outside. */
    private static final String WITHOUT_ATTACH = "-XX:+DisableAttachMechanism";

    private static final String ARCHIVE = "-XX:SharedArchiveFile=";
    private static final String MAIN = "org.robonewbie.app.Main";

    private StudentJava() {}

    /**
     * Returns the command line of a process that grades a program or lets an exercise try it.
     *
     * @param javaOptions options of this Java
     * @param arguments what follows the command
     * @return program and arguments
     */
    public static List<String> grade(List<String> javaOptions, List<String> arguments) {
        List<String> options = new ArrayList<>(List.of("-Xmx" + MEGABYTES + "m", "-XX:+ExitOnOutOfMemoryError"));
        options.addAll(javaOptions);
        return command(
                options, Stream.concat(Stream.of(COMMAND), arguments.stream()).toList());
    }

    /**
     * Returns the command line of a process that is ready to run a program when it is told which.
     *
     * @return program and arguments
     */
    public static List<String> waiting() {
        return command(
                List.of("-Xmx" + MEGABYTES + "m", "-XX:+ExitOnOutOfMemoryError", QUICK_START), List.of("run", ON_CALL));
    }

    /**
     * Returns the command line of a process of this program.
     *
     * @param javaOptions options of this Java
     * @param arguments command and what follows it
     * @return program and arguments
     */
    public static List<String> command(List<String> javaOptions, List<String> arguments) {
        List<String> command = new ArrayList<>(List.of(
                Path.of(System.getProperty("java.home"), "bin", "java").toString(),
                "-XX:+UseSerialGC",
                WITHOUT_ATTACH));
        command.addAll(startArchive());
        command.addAll(javaOptions);
        command.addAll(List.of("-cp", ClassPath.ofThisProgram().option(), MAIN));
        command.addAll(arguments);
        return command;
    }

    /** The archive of prepared classes with which this program was started, if it was: the other process starts as quickly. */
    private static List<String> startArchive() {
        return ManagementFactory.getRuntimeMXBean().getInputArguments().stream()
                .filter(option -> option.startsWith(ARCHIVE))
                .toList();
    }
}
