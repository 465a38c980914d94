package org.robonewbie.studio.program;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import org.robonewbie.programs.Remark;
import org.robonewbie.programs.completion.Proposal;

/** Compiles and starts students' programs for the pages. Thread-safe. */
public interface CompilerService {

    /** {@return the programs' folder, which is also the working directory of their processes} */
    Path folder();

    /** {@return the names of the available examples, in display order} */
    List<String> examples();

    /**
     * Returns the source of an example.
     *
     * @param name one of {@link #examples}
     * @return its text; empty if there is no such example
     */
    Optional<String> example(String name);

    /**
     * Returns the source of a new program.
     *
     * @param file the file to be created, which determines the class and package names
     * @param text the template, such as an example; empty for a minimal program that moves a robot
     * @return its text
     */
    String newProgram(Path file, Optional<String> text);

    /**
     * Compiles a possibly unsaved program together with the other files in its folder.
     *
     * @param file the file in which the program is or will be saved
     * @param text text in the editor
     * @return the diagnostics, in the order of their positions in the text
     */
    List<Remark> check(Path file, String text);

    /**
     * Returns completion proposals.
     *
     * @param file the file in which the program is or will be saved
     * @param text text in the editor
     * @param at index of the cursor
     * @return the proposals, most likely first
     */
    List<Proposal> complete(Path file, String text, int at);

    /**
     * Compiles a saved program and starts it in its own process.
     *
     * @param file the program
     * @param beforeStart called after a successful compilation, before the process starts
     * @param port TCP port of the simulator
     * @return the process; empty if the program has errors, which {@link #check} reports
     * @throws IOException if the process cannot be started
     * @throws IllegalArgumentException if this file cannot be run; the message says what to do
     */
    Optional<RunningProgram> start(Path file, int port, Runnable beforeStart) throws IOException;

    /** {@return the program that runs when the studio opens, if there is one} */
    default Optional<FirstProgram> first() {
        return Optional.empty();
    }
}
