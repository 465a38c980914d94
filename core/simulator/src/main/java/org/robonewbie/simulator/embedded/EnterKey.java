package org.robonewbie.simulator.embedded;

import java.io.IOException;
import java.io.InputStream;
import java.io.PrintStream;
import java.net.URI;
import java.util.Arrays;
import java.util.function.Supplier;

/** Prints a new address for a view whenever Enter is pressed in the terminal, because each address can be used only once. */
public final class EnterKey {

    /**
     * System property set by the launcher, which also ensures that a background process is not suspended when it reads from the
     * terminal.
     */
    private static final String TERMINAL = "robonewbie.terminal";

    private static final String HINT = " (valid once; press Enter here for a new address)";
    private static final int MAX_LINE_BYTES = 4096;

    private EnterKey() {}

    /**
     * Starts listening if the launcher has started this process in a terminal. Once the program in this process reads
     * from standard input, the program receives the lines instead.
     *
     * @param view the view
     * @return a hint to print after the first address; empty if not listening
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

    /**
     * Prints an address for each line of input; once the program has started reading, passes the lines to it instead.
     */
    static void listen(InputStream keyboard, SharedInput program, Supplier<URI> addresses, PrintStream terminal) {
        byte[] line = new byte[MAX_LINE_BYTES];
        try (program) {
            for (int length = keyboard.read(line); length >= 0; length = keyboard.read(line)) {
                if (!program.offer(Arrays.copyOf(line, length)) && line[length - 1] == '\n') {
                    terminal.println("Studio: " + addresses.get());
                }
            }
        } catch (IOException inBackground) {
            // The terminal now belongs to another program.
        }
    }
}
