package org.robonewbie.app.course;

import java.io.BufferedReader;
import java.io.IOException;
import java.util.concurrent.TimeUnit;
import java.util.function.Consumer;

/**
 * What the process of a student prints, line by line. As soon as the student's program may run, each line is marked, so that none can
 * be taken for a verdict.
 */
final class StudentOutput {

    /** Stands before each line of a student's program. */
    static final String MARK = "  program| ";

    /** Longer lines are cut into pieces, so that a program that never ends its line takes no memory of the judge. */
    private static final int MOST_CHARACTERS = 1000;

    private final Thread reader;

    private StudentOutput(Thread reader) {
        this.reader = reader;
    }

    static StudentOutput of(Student student, Consumer<String> hearer) {
        Thread reader = new Thread(() -> read(student, hearer), "output-of-program");
        reader.setDaemon(true);
        reader.start();
        return new StudentOutput(reader);
    }

    private static void read(Student student, Consumer<String> hearer) {
        StringBuilder line = new StringBuilder();
        try (BufferedReader characters = student.process().inputReader()) {
            for (int next = characters.read(); next >= 0; next = characters.read()) {
                if (next == '\n' || line.length() >= MOST_CHARACTERS) {
                    tell(line, student, hearer);
                }
                if (next != '\n' && next != '\r') {
                    line.append((char) next);
                }
            }
        } catch (IOException end) {
            // The process was ended while it was printing.
        }
        if (line.length() > 0) {
            tell(line, student, hearer);
        }
    }

    private static void tell(StringBuilder line, Student student, Consumer<String> hearer) {
        hearer.accept((student.isReady() ? MARK : "") + line);
        line.setLength(0);
    }

    /** Waits for the last words of a process that has ended; programs that it has started may keep the line open, but not for long. */
    void awaitEnd() {
        try {
            reader.join(TimeUnit.SECONDS.toMillis(1));
        } catch (InterruptedException stopped) {
            Thread.currentThread().interrupt();
        }
    }
}
