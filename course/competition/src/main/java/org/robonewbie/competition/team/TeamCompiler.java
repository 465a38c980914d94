package org.robonewbie.competition.team;

import java.io.ByteArrayOutputStream;
import java.io.FileDescriptor;
import java.io.FileOutputStream;
import java.io.IOException;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;

/**
 * The class of the process that compiles a team's program: what the compiler does with strange sources costs this process only. It
 * prints the classes that can be started, or what the compiler complains of.
 */
public final class TeamCompiler {

    /** Exit code for sources with mistakes. */
    static final int MISTAKES = 1;

    /** How the lines begin that name a class which can be started. */
    static final String CLASS = "class: ";

    /** How the lines begin that say how a file was read. */
    static final String NOTE = "note: ";

    /** The second argument for a project, whose folders belong to it. */
    static final String DEEP = "deep";

    /** The compiler prints it with a thousand lines of its own inside. */
    private static final String OVERTAXED = StackOverflowError.class.getName();

    private static final String TOO_DEEP =
            "The compiler cannot read these sources: an expression or a block is nested too deeply.";

    private TeamCompiler() {}

    /**
     * Compiles a folder.
     *
     * @param arguments the folder, whether it is deep, and the folder for the classes
     * @throws IOException if files cannot be read or written
     */
    public static void main(String[] arguments) throws IOException {
        PrintStream out = new PrintStream(new FileOutputStream(FileDescriptor.out), true, StandardCharsets.UTF_8);
        ByteArrayOutputStream notes = new ByteArrayOutputStream();
        System.setErr(new PrintStream(notes, true, StandardCharsets.UTF_8));
        SourceFolder sources = new SourceFolder(Path.of(arguments[0]), arguments[1].equals(DEEP));
        Path classes = Path.of(arguments[2]);
        try {
            sources.compile(classes)
                    .ifPresent(complaint -> end(out, complaint.contains(OVERTAXED) ? TOO_DEEP : complaint));
            MainClasses.in(classes, sources.classPath(classes)).forEach(name -> out.println(CLASS + name));
            notes.toString(StandardCharsets.UTF_8).lines().forEach(line -> out.println(NOTE + line));
        } catch (StackOverflowError | IllegalStateException overtaxed) {
            end(out, TOO_DEEP);
        }
    }

    private static void end(PrintStream out, String complaint) {
        out.println(complaint);
        System.exit(MISTAKES);
    }
}
