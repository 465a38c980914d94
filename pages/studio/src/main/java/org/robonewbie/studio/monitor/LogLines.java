package org.robonewbie.studio.monitor;

import java.io.BufferedInputStream;
import java.io.IOException;
import java.io.InputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.zip.GZIPInputStream;
import org.robonewbie.protocol.frame.MessageBuffer;

/** The lines of a log, which may be compressed with gzip. */
final class LogLines implements AutoCloseable {

    private static final int GZIP_MARK = 0x1f;
    private static final int BUFFER_BYTES = 1 << 16;

    /** Maximum length of a line; servers send no messages that long. */
    private static final int MAX_LINE_BYTES = 1 << 24;

    private final InputStream in;
    private final byte[] buffer = new byte[BUFFER_BYTES];
    private int at;
    private int end;
    private long number;
    private long bytes;

    private LogLines(InputStream in) {
        this.in = in;
    }

    static LogLines open(Path log) throws IOException {
        InputStream raw = new BufferedInputStream(Files.newInputStream(log), BUFFER_BYTES);
        try {
            raw.mark(1);
            boolean packed = raw.read() == GZIP_MARK;
            raw.reset();
            return new LogLines(packed ? new GZIPInputStream(raw, BUFFER_BYTES) : raw);
        } catch (IOException unreadable) {
            raw.close();
            throw unreadable;
        }
    }

    /** Returns the number of the last line, from 1. */
    long number() {
        return number;
    }

    /** Returns the number of bytes read so far, after decompression. */
    long bytes() {
        return bytes;
    }

    /**
     * Reads the next line without its line break.
     *
     * @return false at the end of the log
     * @throws IOException if the log cannot be read or a line is too long
     */
    boolean next(MessageBuffer line) throws IOException {
        line.clear();
        if (at == end && !fill()) {
            return false;
        }
        number++;
        do {
            int start = at;
            while (at < end && buffer[at] != '\n') {
                at++;
            }
            append(line, start);
            if (at < end) {
                at++;
                return true;
            }
        } while (fill());
        return true;
    }

    private void append(MessageBuffer line, int start) throws IOException {
        int old = line.length();
        int count = at - start;
        if (old + count > MAX_LINE_BYTES) {
            throw new IOException("Line " + number + " has more than " + MAX_LINE_BYTES
                    + " bytes; no server writes messages that long.");
        }
        line.resize(old + count);
        System.arraycopy(buffer, start, line.bytes(), old, count);
    }

    private boolean fill() throws IOException {
        at = 0;
        end = Math.max(0, in.read(buffer));
        bytes += end;
        return end > 0;
    }

    @Override
    public void close() throws IOException {
        in.close();
    }
}
