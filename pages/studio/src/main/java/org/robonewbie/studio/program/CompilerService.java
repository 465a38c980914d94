package org.robonewbie.studio.program;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import org.robonewbie.studio.completion.Proposal;

/** Who compiles and starts students' programs for the pages. Any thread may ask. */
public interface CompilerService {

    /** {@return the folder of the programs; processes run in it} */
    Path folder();

    /** {@return names of the examples that can be read, in their order} */
    List<String> examples();

    /**
     * Reads an example.
     *
     * @param name one of {@link #examples}
     * @return its text; empty if there is none of this name
     */
    Optional<String> example(String name);

    /**
     * Returns a program to begin with.
     *
     * @param file where it will be, which names class and package
     * @param text what to take as its text, such as that of an example; empty for the shortest program that moves a robot
     * @return its text
     */
    String newProgram(Path file, Optional<String> text);

    /**
     * Lets the compiler read a program that need not be saved, together with the other files of its folder.
     *
     * @param file where it is or will be
     * @param text what is in the editor
     * @return what the compiler says, in the order of the text
     */
    List<Remark> check(Path file, String text);

    /**
     * Proposes what could be written at a place.
     *
     * @param file where the program is or will be
     * @param text what is in the editor
     * @param at index of the place
     * @return proposals, the most likely ones first
     */
    List<Proposal> complete(Path file, String text, int at);

    /**
     * Compiles a saved program and starts it in a process of its own.
     *
     * @param file the program
     * @param beforeStart is called when the program can be started, before it is
     * @param port where the simulator awaits it
     * @return the process; empty if the program has mistakes, which {@link #check} names
     * @throws IOException if the process cannot be started
     * @throws IllegalArgumentException if this file cannot be run; the message says what to do
     */
    Optional<RunningProgram> start(Path file, int port, Runnable beforeStart) throws IOException;
}
