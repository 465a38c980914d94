package org.robonewbie.programs.process;

import java.lang.management.ManagementFactory;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.Stream;
import org.robonewbie.programs.ClassPath;

/** The command lines of Java processes: this Java, into which no other process can load code. */
public final class JavaCommand {

    /** Default memory of a program, in megabytes. */
    public static final int MEGABYTES = 512;

    /** Option for programs that compute little: Java need not spend time on making them fast. */
    public static final String QUICK_START = "-XX:TieredStopAtLevel=1";

    private static final String ARCHIVE = "-XX:SharedArchiveFile=";

    private static final String MAIN = "org.robonewbie.app.Main";

    private JavaCommand() {}

    /**
     * Returns the command line of a command of RoboNewbie.
     *
     * @param arguments command and what follows it
     * @return program and arguments
     */
    public static List<String> ofCommand(List<String> arguments) {
        return of(List.of(), ClassPath.ofThisProgram(), MAIN, arguments);
    }

    /**
     * Returns the options that limit the memory of a Java process.
     *
     * @param megabytes its heap
     * @return the options
     */
    public static List<String> withMemory(int megabytes) {
        return List.of("-Xmx" + megabytes + "m", "-XX:+ExitOnOutOfMemoryError");
    }

    /**
     * Returns a command line.
     *
     * @param options options of this Java
     * @param classPath where the classes are
     * @param mainClass name of the class that starts
     * @param arguments its arguments
     * @return program and arguments
     */
    public static List<String> of(List<String> options, ClassPath classPath, String mainClass, List<String> arguments) {
        List<String> command = new ArrayList<>(List.of(
                Path.of(System.getProperty("java.home"), "bin", "java").toString(),
                "-XX:+UseSerialGC",
                "-XX:+DisableAttachMechanism"));
        startArchive().map(file -> ARCHIVE + file).forEach(command::add);
        command.addAll(options);
        command.addAll(List.of("-cp", classPath.option(), mainClass));
        command.addAll(arguments);
        return command;
    }

    /**
     * Returns what a process must be able to read.
     *
     * @param classPath its class path
     * @return files and folders
     */
    public static List<Path> readable(ClassPath classPath) {
        return Stream.concat(classPath.readable().stream(), startArchive().map(Path::of))
                .toList();
    }

    /** The archive of prepared classes with which this process was started, if it was: the other one starts as quickly. */
    private static Stream<String> startArchive() {
        return ManagementFactory.getRuntimeMXBean().getInputArguments().stream()
                .filter(option -> option.startsWith(ARCHIVE))
                .map(option -> option.substring(ARCHIVE.length()));
    }
}
