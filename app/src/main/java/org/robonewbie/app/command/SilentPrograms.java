package org.robonewbie.app.command;

import java.io.IOException;
import java.io.OutputStream;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;

/** Discards the output of programs that run in this process. */
final class SilentPrograms {

    private SilentPrograms() {}

    @FunctionalInterface
    interface Work<T> {

        T run() throws IOException;
    }

    /** Runs the work, discarding standard output but not error output. */
    static <T> T complaining(Work<T> work) throws IOException {
        PrintStream out = System.out;
        System.setOut(nowhere());
        try {
            return work.run();
        } finally {
            System.setOut(out);
        }
    }

    /** Runs the work, discarding standard output and error output. */
    static <T> T entirely(Work<T> work) throws IOException {
        PrintStream err = System.err;
        System.setErr(nowhere());
        try {
            return complaining(work);
        } finally {
            System.setErr(err);
        }
    }

    private static PrintStream nowhere() {
        return new PrintStream(OutputStream.nullOutputStream(), false, StandardCharsets.UTF_8);
    }
}
