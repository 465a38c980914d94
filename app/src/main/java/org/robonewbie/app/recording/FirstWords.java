package org.robonewbie.app.recording;

import java.io.IOException;
import java.io.OutputStream;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;

/** Keeps the first line of what a program complains about, and lets people read all of it. */
final class FirstWords extends OutputStream {

    private static final int MOST_BYTES = 300;

    private final OutputStream people;
    private final StringBuilder bytes = new StringBuilder();
    private boolean complete;

    private FirstWords(OutputStream people) {
        this.people = people;
    }

    /** Listens to {@code System.err} from now on. */
    static FirstWords listen() {
        FirstWords words = new FirstWords(System.err);
        System.setErr(new PrintStream(words, true, StandardCharsets.UTF_8));
        return words;
    }

    /** Forgets what it has heard. */
    synchronized void forget() {
        bytes.setLength(0);
        complete = false;
    }

    /** The first line since then, in one piece; empty if there is none. */
    synchronized String line() {
        return new String(bytes.toString().getBytes(StandardCharsets.ISO_8859_1), StandardCharsets.UTF_8).strip();
    }

    @Override
    public synchronized void write(int next) throws IOException {
        people.write(next);
        if (next == '\n') {
            complete |= !line().isEmpty();
        } else if (!complete && bytes.length() < MOST_BYTES) {
            bytes.append((char) (next & 0xFF));
        }
    }

    @Override
    public void flush() throws IOException {
        people.flush();
    }
}
