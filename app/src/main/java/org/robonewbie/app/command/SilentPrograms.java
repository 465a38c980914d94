package org.robonewbie.app.command;

import java.io.IOException;
import java.io.OutputStream;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;

/** Keeps quiet what programs print while something is done; there may be thousands of trials. */
final class SilentPrograms {

    private SilentPrograms() {}

    /** Something to do in silence. */
    @FunctionalInterface
    interface Work<T> {

        T run() throws IOException;
    }

    /** Keeps quiet what programs print, but not what they complain about. */
    static <T> T complaining(Work<T> work) throws IOException {
        PrintStream out = System.out;
        System.setOut(nowhere());
        try {
            return work.run();
        } finally {
            System.setOut(out);
        }
    }

    /** Keeps everything quiet. */
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
