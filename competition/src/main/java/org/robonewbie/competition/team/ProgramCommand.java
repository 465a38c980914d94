package org.robonewbie.competition.team;

import java.io.File;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.Stream;

/**
 * The command line that starts a program.
 *
 * @param program the program
 * @param start what it receives
 * @param limits its limits
 */
record ProgramCommand(TeamProgram program, Start start, Limits limits) {

    /** Words for a program that keeps its temporary files in a folder. */
    List<String> words(Path temporary) {
        List<String> words = new ArrayList<>(java(limits.memoryMegabytes()));
        words.add("-Djava.io.tmpdir=" + temporary.toAbsolutePath());
        if (program instanceof TeamProgram.OfJava java) {
            words.addAll(List.of("-cp", classPath(java.classPath()), TeamGuard.class.getName(), TeamGuard.CLASS));
            words.add(java.mainClasses().getOrDefault(start.role(), ""));
            words.addAll(start.options(java.together()));
            words.add("--no-browser"); // and not headless: the world's patience decides about endless loops, not the
            // agent's
        } else if (program instanceof TeamProgram.OfCommand command) {
            words.addAll(List.of("-cp", classPath(List.of()), TeamGuard.class.getName(), TeamGuard.COMMAND));
            words.addAll(start.fill(command.words(), command.together()));
        }
        return words;
    }

    /** The words that start Java, without class path and class. */
    static List<String> java(int megabytes) {
        return List.of(
                Path.of(System.getProperty("java.home"), "bin", "java").toString(),
                "-XX:+UseSerialGC",
                "-XX:TieredStopAtLevel=1",
                "-XX:+ExitOnOutOfMemoryError",
                "-XX:+DisableAttachMechanism",
                "-Xmx" + megabytes + "m",
                "-Djava.awt.headless=true");
    }

    /** The class path of RoboNewbie with places of a team behind it. */
    static String classPath(List<Path> own) {
        return String.join(
                File.pathSeparator,
                Stream.concat(ownClassPath().stream(), own.stream())
                        .map(place -> place.toAbsolutePath().toString())
                        .toList());
    }

    /** Where RoboNewbie and Java are. */
    static List<Path> ownPlaces() {
        return Stream.concat(ownClassPath().stream(), Stream.of(Path.of(System.getProperty("java.home"))))
                .map(TeamFolder::absolute)
                .toList();
    }

    private static List<Path> ownClassPath() {
        return Stream.of(System.getProperty("java.class.path").split(File.pathSeparator, -1))
                .map(Path::of)
                .toList();
    }
}
