package org.robonewbie.competition.team;

import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.concurrent.TimeUnit;

/** Writes what a program prints into a file, up to a size; what is more, or finds no room on the disk, is read and thrown away. */
final class LogPump {

    private static final int MOST_BYTES = 1_000_000;
    private static final long PATIENCE_MILLISECONDS = TimeUnit.SECONDS.toMillis(3);
    private static final String LACK_OF_MEMORY = "java.lang.OutOfMemoryError";

    private final Thread thread;
    private volatile boolean lackOfMemory;

    private LogPump(InputStream from, Path file) {
        thread = new Thread(() -> pump(from, file), "log-pump");
        thread.setDaemon(true);
    }

    static LogPump start(InputStream from, Path file) {
        LogPump pump = new LogPump(from, file);
        pump.thread.start();
        return pump;
    }

    /** Waits until all is written, or some seconds. */
    void await() {
        try {
            thread.join(PATIENCE_MILLISECONDS);
        } catch (InterruptedException stopped) {
            Thread.currentThread().interrupt();
        }
    }

    /** Whether Java has ended the program since its memory was full. */
    boolean tellsLackOfMemory() {
        return lackOfMemory;
    }

    private void pump(InputStream from, Path file) {
        byte[] buffer = new byte[8192];
        try (from;
                OutputStream to = open(file)) {
            boolean writable = true;
            long written = 0;
            for (int count = from.read(buffer); count >= 0; count = from.read(buffer)) {
                String text = new String(buffer, 0, count, StandardCharsets.ISO_8859_1);
                lackOfMemory |= text.contains("Terminating due to " + LACK_OF_MEMORY);
                if (writable && written < MOST_BYTES) {
                    writable = isWritten(buffer, count, to);
                    written += count;
                }
            }
        } catch (IOException ended) {
            // The program is at its end.
        }
    }

    /** A disk that is full costs the log only: a program of which nobody reads would stand still. */
    private static boolean isWritten(byte[] bytes, int count, OutputStream to) {
        try {
            to.write(bytes, 0, count);
            return true;
        } catch (IOException full) {
            return false;
        }
    }

    private static OutputStream open(Path file) {
        try {
            return Files.newOutputStream(file);
        } catch (IOException unwritable) {
            return OutputStream.nullOutputStream();
        }
    }
}
