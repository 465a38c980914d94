package org.robonewbie.agent.running;

import java.io.BufferedWriter;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.util.List;
import java.util.Optional;
import org.robonewbie.agent.log.LogLine;
import org.robonewbie.agent.log.LogOverflow;
import org.robonewbie.nao.file.TemporaryFiles;

/** Temporary file for the oldest lines of a very long log. Lines are moved in small batches so that no cycle is late. */
public final class LogFile implements LogOverflow {

    private Optional<Path> file = Optional.empty();
    private long lines;

    /** Creates an instance; the file is created on demand. */
    public LogFile() {}

    @Override
    public void take(List<LogLine> oldest) {
        try {
            Path path = file.isPresent() ? file.get() : TemporaryFiles.file("robonewbie-log-", ".txt");
            file = Optional.of(path);
            try (BufferedWriter writer = Files.newBufferedWriter(path, StandardOpenOption.APPEND)) {
                for (LogLine line : oldest) {
                    writer.write(line + System.lineSeparator());
                }
            }
            lines += oldest.size();
        } catch (IOException diskFull) {
            throw new UncheckedIOException("The log fits neither in memory nor on the disk", diskFull);
        }
    }

    @Override
    public String closingNote() {
        String note = file.map(path -> "(the first " + lines + " lines are in " + path + ")\n")
                .orElse("");
        file = Optional.empty();
        lines = 0;
        return note;
    }
}
