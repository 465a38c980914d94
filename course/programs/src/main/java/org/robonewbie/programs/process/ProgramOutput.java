package org.robonewbie.programs.process;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.nio.charset.Charset;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.TimeUnit;
import java.util.function.Consumer;

/**
 * Captures the output of a process, up to a maximum size. A thread reads continuously, so the program never blocks on a
 * full pipe. Lines that begin with {@link #ANSWER} are answers to calls; see {@link ParentProcess}.
 */
public final class ProgramOutput {

    /** First character of an answer; not allowed in other output. */
    static final char ANSWER = '\u0001';

    private static final int MAX_FILE_BYTES = 1_000_000;
    private static final int MAX_LINE_BYTES = 1000;
    private static final int MAX_ANSWER_BYTES = 10_000;
    private static final int MAX_END_CHARACTERS = 4000;
    private static final int MAX_LINES = 1000;
    private static final String LACK_OF_MEMORY = "Terminating due to java.lang.OutOfMemoryError";

    private final OutputStream file;
    private final Consumer<String> lines;
    private final Consumer<String> answers;
    private final ByteArrayOutputStream line = new ByteArrayOutputStream();
    private final List<String> first = new ArrayList<>();
    private final StringBuilder end = new StringBuilder();
    private Thread reader = new Thread();
    private boolean isAnswer;
    private long written;
    private volatile boolean lackOfMemory;

    private ProgramOutput(OutputStream file, Consumer<String> lines, Consumer<String> answers) {
        this.file = file;
        this.lines = lines;
        this.answers = answers;
    }

    /**
     * Writes the output to a file. Once the size limit is reached or the disk is full, further output is discarded.
     *
     * @param file the file, which is replaced
     * @return the capture for one process
     */
    public static ProgramOutput into(Path file) {
        OutputStream out;
        try {
            out = Files.newOutputStream(file);
        } catch (IOException unwritable) {
            out = OutputStream.nullOutputStream();
        }
        return new ProgramOutput(out, text -> {}, text -> {});
    }

    /**
     * Forwards the output line by line.
     *
     * @param lines receives each line; long lines are split
     * @param answers receives each answer, and an empty one at the end
     * @return the capture for one process
     */
    public static ProgramOutput of(Consumer<String> lines, Consumer<String> answers) {
        return new ProgramOutput(OutputStream.nullOutputStream(), lines, answers);
    }

    void read(InputStream stream) {
        reader = new Thread(() -> readAll(stream), "output-of-program");
        reader.setDaemon(true);
        reader.start();
    }

    private void readAll(InputStream stream) {
        byte[] bytes = new byte[8192];
        try (stream;
                file) {
            for (int count = stream.read(bytes); count >= 0; count = stream.read(bytes)) {
                keep(bytes, count);
                take(bytes, count);
            }
        } catch (IOException ended) {
            // The process ended while its output was being read.
        }
        if (line.size() > 0) {
            finishLine();
        }
        answers.accept("");
    }

    private void keep(byte[] bytes, int count) {
        if (written < MAX_FILE_BYTES) {
            try {
                file.write(bytes, 0, count);
                written += count;
            } catch (IOException full) {
                written = MAX_FILE_BYTES;
            }
        }
    }

    private synchronized void take(byte[] bytes, int count) {
        for (int i = 0; i < count; i++) {
            take(bytes[i]);
        }
    }

    private void take(byte next) {
        if (next == ANSWER && line.size() > 0) {
            finishLine();
        }
        if (next == '\n') {
            finishLine();
        } else if (next == ANSWER) {
            isAnswer = true;
        } else if (next != '\r') {
            line.write(next);
            if (line.size() == (isAnswer ? MAX_ANSWER_BYTES : MAX_LINE_BYTES)) {
                finishLine();
            }
        }
    }

    private synchronized void finishLine() {
        String text = decoded(line.toByteArray());
        line.reset();
        if (isAnswer) {
            isAnswer = false;
            answers.accept(text);
            return;
        }
        lackOfMemory |= text.contains(LACK_OF_MEMORY);
        if (first.size() < MAX_LINES) {
            first.add(text);
        }
        end.append(text).append('\n');
        end.delete(0, Math.max(0, end.length() - MAX_END_CHARACTERS));
        lines.accept(text);
    }

    /** Decodes output as UTF-8 or, if it is not valid UTF-8, with the system's encoding. */
    private static String decoded(byte[] bytes) {
        String text = new String(bytes, StandardCharsets.UTF_8);
        return text.indexOf('\uFFFD') < 0 ? text : new String(bytes, Charset.defaultCharset());
    }

    /** {@return the first lines of the output, without answers} */
    public synchronized List<String> lines() {
        return List.copyOf(first);
    }

    /** {@return the last part of the output} */
    public synchronized String end() {
        return end + (isAnswer ? "" : decoded(line.toByteArray()));
    }

    /** Returns whether the JVM terminated the program with an {@link OutOfMemoryError}. */
    boolean isOutOfMemory() {
        return lackOfMemory;
    }

    /** Waits until all output has been read, but only for a few seconds, because descendants may keep the pipe open. */
    void await() {
        try {
            reader.join(TimeUnit.SECONDS.toMillis(3));
        } catch (InterruptedException stopped) {
            Thread.currentThread().interrupt();
        }
    }
}
