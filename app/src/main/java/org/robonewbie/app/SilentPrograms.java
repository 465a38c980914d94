package org.robonewbie.app;

import java.io.OutputStream;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;

/** Keeps quiet what programs print, as long as it is open; there may be thousands of trials. */
final class SilentPrograms implements AutoCloseable {

    private final PrintStream out = System.out;
    private final PrintStream err = System.err;

    private SilentPrograms() {}

    /** Keeps quiet what programs print, but not what they complain about. */
    static SilentPrograms complaining() {
        SilentPrograms silence = new SilentPrograms();
        System.setOut(nowhere());
        return silence;
    }

    /** Keeps everything quiet. */
    static SilentPrograms entirely() {
        SilentPrograms silence = complaining();
        System.setErr(nowhere());
        return silence;
    }

    private static PrintStream nowhere() {
        return new PrintStream(OutputStream.nullOutputStream(), false, StandardCharsets.UTF_8);
    }

    @Override
    public void close() {
        System.setOut(out);
        System.setErr(err);
    }
}
