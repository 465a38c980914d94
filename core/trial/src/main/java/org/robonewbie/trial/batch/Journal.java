package org.robonewbie.trial.batch;

import java.io.IOException;
import java.io.Writer;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.util.List;
import org.robonewbie.nao.file.AtomicFile;
import org.robonewbie.nao.file.UnwritableFileException;

/**
 * Text file with the results of a batch, from which an interrupted run resumes. It consists of a header that identifies the
 * run, and a line for each result, written as soon as the result is available. An incomplete last line is dropped.
 *
 * <pre>{@code
 * try (Journal journal = Journal.open(Path.of("steps.journal"), "steps of seeds 1 to 100")) {
 *     journal.lines().forEach(line -> known.add(line));
 *     journal.add("17,203");
 * }
 * }</pre>
 */
public final class Journal implements AutoCloseable {

    private final Path file;
    private final List<String> lines;
    private final Writer writer;

    private Journal(Path file, List<String> lines, Writer writer) {
        this.file = file;
        this.lines = List.copyOf(lines);
        this.writer = writer;
    }

    /**
     * Opens a journal and keeps existing results of the same run.
     *
     * @param file the file, which is created if it does not exist
     * @param header one line that identifies the run, with all options on which a result depends; empty if the run is
     *     identified by another file
     * @return the journal
     * @throws IOException if the file cannot be read or written
     * @throws IllegalArgumentException if it belongs to another run; the message says what to do
     */
    public static Journal open(Path file, String header) throws IOException {
        try {
            String text = Files.exists(file) ? Files.readString(file) : "";
            String complete = text.substring(0, text.lastIndexOf('\n') + 1);
            List<String> lines = complete.lines().toList();
            int headers = header.isEmpty() ? 0 : Math.min(1, lines.size());
            if (headers > 0 && !lines.get(0).equals(header)) {
                throw new IllegalArgumentException(
                        file + " belongs to another run:\n  " + lines.get(0) + "\nand not to:\n  " + header
                                + "\nUse the same options as before, or delete the file to start over.");
            }
            if (lines.isEmpty() || complete.length() < text.length()) {
                AtomicFile.write(file, lines.isEmpty() && !header.isEmpty() ? header + "\n" : complete);
            }
            Writer writer = Files.newBufferedWriter(file, StandardCharsets.UTF_8, StandardOpenOption.APPEND);
            return new Journal(file, lines.subList(headers, lines.size()), writer);
        } catch (IOException unwritable) {
            throw UnwritableFileException.of(file, unwritable);
        }
    }

    /** {@return the complete lines that the file contained when it was opened, without the header} */
    public List<String> lines() {
        return lines;
    }

    /**
     * Appends a result to the file.
     *
     * @param line the result as text
     * @throws IOException if the file cannot be written
     */
    public void add(String line) throws IOException {
        try {
            writer.write(line + "\n");
            writer.flush();
        } catch (IOException unwritable) {
            throw UnwritableFileException.of(file, unwritable);
        }
    }

    /** Closes the file and keeps it, so that the run can resume. */
    @Override
    public void close() throws IOException {
        try {
            writer.close();
        } catch (IOException unwritable) {
            throw UnwritableFileException.of(file, unwritable);
        }
    }

    /**
     * Closes and deletes the file. Call this when the run is complete.
     *
     * @throws IOException if the file cannot be deleted
     */
    public void delete() throws IOException {
        close();
        Files.deleteIfExists(file);
    }
}
