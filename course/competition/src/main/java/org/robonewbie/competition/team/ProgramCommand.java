package org.robonewbie.competition.team;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;

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
            words.addAll(List.of("-cp", classPathOf(program).option(), TeamGuard.class.getName(), TeamGuard.CLASS));
            words.add(java.mainClasses().getOrDefault(start.role(), ""));
            words.addAll(start.options(java.together()));
            words.add("--no-browser"); // and not headless: the world's patience decides about endless loops, not the
            // agent's
        } else if (program instanceof TeamProgram.OfCommand command) {
            words.addAll(List.of("-cp", classPathOf(program).option(), TeamGuard.class.getName(), TeamGuard.COMMAND));
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

    /** The classes of RoboNewbie, and those of a program in Java. */
    static ClassPath classPathOf(TeamProgram program) {
        ClassPath own = ClassPath.ofThisProgram();
        return program instanceof TeamProgram.OfJava java ? own.with(java.classPath()) : own;
    }
}
