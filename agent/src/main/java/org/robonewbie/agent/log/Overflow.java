package org.robonewbie.agent.log;

import java.io.BufferedWriter;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.util.Deque;
import java.util.Optional;

/** Takes the oldest lines of a very long log out of the memory into a file, a few at a time so that no cycle notices it. */
final class Overflow {

    private Optional<Path> file = Optional.empty();
    private long lines;

    /** Moves lines from the beginning of a log to the end of the file. */
    void take(Deque<LogLine> log, int count) {
        try {
            Path path = file.isPresent() ? file.get() : Files.createTempFile("robonewbie-log-", ".txt");
            file = Optional.of(path);
            try (BufferedWriter writer = Files.newBufferedWriter(path, StandardOpenOption.APPEND)) {
                for (int i = 0; i < count; i++) {
                    writer.write(log.removeFirst() + System.lineSeparator());
                    lines++;
                }
            }
        } catch (IOException diskFull) {
            throw new UncheckedIOException("The log is too long for the memory and for the disk", diskFull);
        }
    }

    /** Says where the lines are; empty if there are none. */
    String note() {
        return file.map(path -> "(the first " + lines + " lines are in " + path + ")\n")
                .orElse("");
    }

    /** Begins a new file with the next lines. */
    void forget() {
        file = Optional.empty();
        lines = 0;
    }
}
