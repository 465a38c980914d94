package org.robonewbie.learning.dataset;

import java.io.BufferedOutputStream;
import java.io.IOException;
import java.io.OutputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.robonewbie.nao.file.AtomicFile;

/** A table that is being written. Under its own name it appears only when it is complete. */
public abstract class TableFile implements AutoCloseable {

    private final Path file;
    private final Path part;
    private final List<Column> columns;
    private final OutputStream out;

    TableFile(Path file, List<Column> columns) throws IOException {
        this.file = file;
        this.part = AtomicFile.part(file);
        this.columns = List.copyOf(columns);
        this.out = new BufferedOutputStream(AtomicFile.begin(file));
    }

    /**
     * Adds a row.
     *
     * @param cells a value for each column, of the kind that the column says
     * @throws IOException if it cannot be written
     * @throws IllegalArgumentException if there are more or fewer cells than columns
     */
    public final void add(List<Object> cells) throws IOException {
        if (cells.size() != columns.size()) {
            throw new IllegalArgumentException("A row of " + cells.size() + " cells for a table with " + columns.size()
                    + " columns (" + file + ").");
        }
        write(cells);
    }

    /**
     * Completes the table and gives it its name; an older file of that name is replaced.
     *
     * @throws IOException if that fails
     */
    public final void finish() throws IOException {
        writeEnd();
        out.close();
        AtomicFile.moveIntoPlace(file);
    }

    /** Discards the table unless it is finished. */
    @Override
    public final void close() throws IOException {
        try {
            out.close();
        } finally {
            Files.deleteIfExists(part);
        }
    }

    abstract void write(List<Object> cells) throws IOException;

    /** Appends all rows of a finished table of the same format and columns. */
    abstract void append(Path other) throws IOException;

    abstract void writeEnd() throws IOException;

    final List<Column> columns() {
        return columns;
    }

    final OutputStream out() {
        return out;
    }
}
