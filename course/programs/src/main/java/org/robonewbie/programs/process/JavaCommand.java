package org.robonewbie.programs.process;

import java.lang.management.ManagementFactory;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.Stream;
import org.robonewbie.programs.ClassPath;

/**
 * Command lines of Java processes. Each process uses the same Java installation as this process, and other processes cannot
 * attach to it.
 */
public final class JavaCommand {

    /** Default maximum heap size of a program in megabytes. */
    public static final int MEGABYTES = 512;

    /** JVM option for programs that do little computation: speeds up their start by disabling the optimising compiler. */
    public static final String QUICK_START = "-XX:TieredStopAtLevel=1";

    private static final String ARCHIVE = "-XX:SharedArchiveFile=";

    private static final String MAIN = "org.robonewbie.app.Main";

    private JavaCommand() {}

    /**
     * Returns the command line that runs a RoboNewbie command.
     *
     * @param arguments the command and its arguments
     * @return program and arguments
     */
    public static List<String> ofCommand(List<String> arguments) {
        return of(List.of(), ClassPath.ofThisProgram(), MAIN, arguments);
    }

    /**
     * Returns the command line that runs {@link ProgramMain}.
     *
     * @param megabytes maximum heap size in megabytes
     * @param options other options for the JVM
     * @param classPath the class path
     * @param arguments the arguments of {@link ProgramMain}
     * @return program and arguments
     */
    public static List<String> ofProgram(
            int megabytes, List<String> options, ClassPath classPath, List<String> arguments) {
        List<String> all = new ArrayList<>(List.of("-Xmx" + megabytes + "m", "-XX:+ExitOnOutOfMemoryError"));
        all.addAll(options);
        return of(all, classPath, ProgramMain.class.getName(), arguments);
    }

    /**
     * Returns a command line.
     *
     * @param options options for the JVM
     * @param classPath the class path
     * @param mainClass name of the main class
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
     * Returns the files that a Java process needs to read.
     *
     * @param classPath its class path
     * @return files and folders
     */
    public static List<Path> readable(ClassPath classPath) {
        return Stream.concat(classPath.readable().stream(), startArchive().map(Path::of))
                .toList();
    }

    /**
     * Returns the option for the class data sharing (CDS) archive of this process, which also speeds up the start of a child.
     */
    private static Stream<String> startArchive() {
        return ManagementFactory.getRuntimeMXBean().getInputArguments().stream()
                .filter(option -> option.startsWith(ARCHIVE))
                .map(option -> option.substring(ARCHIVE.length()));
    }
}
