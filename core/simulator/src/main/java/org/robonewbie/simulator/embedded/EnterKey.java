package org.robonewbie.simulator.embedded;

import java.io.IOException;
import java.io.InputStream;
import java.io.PrintStream;
import java.net.URI;
import java.util.Arrays;
import java.util.function.Supplier;

/** Prints another address of a view whenever Enter is pressed in the terminal, since an address lets one browser in only once. */
public final class EnterKey {

    /** Set by the launcher, which also sees to it that a process in the background is not stopped when it reads. */
    private static final String TERMINAL = "robonewbie.terminal";

    private static final String HINT = " (opens once; press Enter here for another address)";
    private static final int LONGEST_LINE = 4096;

    private EnterKey() {}

    /**
     * Starts to listen, if the launcher has started this process in a terminal; ends with the process. A program of this process
     * that reads the standard input receives it from then on.
     *
     * @param view the view
     * @return what to print after the first address; empty if nothing listens
     */
    public static String listen(Viewer.View view) {
        if (!Boolean.getBoolean(TERMINAL)) {
            return "";
        }
        InputStream keyboard = System.in;
        SharedInput shared = new SharedInput();
        System.setIn(shared);
        Thread listener = new Thread(() -> listen(keyboard, shared, view::oneTimeAddress, System.out), "enter-key");
        listener.setDaemon(true);
        listener.start();
        return HINT;
    }

    /** Prints an address for each line until the input ends, or hands the lines to the program that reads them. */
    static void listen(InputStream keyboard, SharedInput program, Supplier<URI> addresses, PrintStream terminal) {
        byte[] line = new byte[LONGEST_LINE];
        try (program) {
            for (int length = keyboard.read(line); length >= 0; length = keyboard.read(line)) {
                if (!program.offer(Arrays.copyOf(line, length)) && line[length - 1] == '\n') {
                    terminal.println("Studio: " + addresses.get());
                }
            }
        } catch (IOException inBackground) {
            // The terminal belongs to another program now.
        }
    }
}
