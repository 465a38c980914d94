package org.robonewbie.learning.dataset;

import java.io.BufferedInputStream;
import java.io.BufferedOutputStream;
import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Collectors;
import org.robonewbie.nao.file.AtomicFile;
import org.robonewbie.nao.text.Csv;

/**
 * Writer for a CSV table (RFC 4180 in UTF-8, with line feeds as line terminators). The file gets its final name only
 * when it is complete.
 */
public final class TableFile implements AutoCloseable {

    static final String EXTENSION = ".csv";

    private final Path file;
    private final Path part;
    private final List<Column> columns;
    private final OutputStream out;

    /**
     * Begins a table.
     *
     * @param file the file that {@link #finish} creates
     * @param columns the columns; their names form the first line
     * @throws IOException if the file cannot be written
     */
    TableFile(Path file, List<Column> columns) throws IOException {
        this.file = file;
        this.part = AtomicFile.part(file);
        this.columns = List.copyOf(columns);
        this.out = new BufferedOutputStream(AtomicFile.begin(file));
        writeLine(columns.stream().<Object>map(Column::name).toList());
    }

    /**
     * Adds a row.
     *
     * @param cells a value for each column, of the column's kind
     * @throws IOException if the row cannot be written
     * @throws IllegalArgumentException if the number of cells differs from the number of columns
     */
    public void add(List<Object> cells) throws IOException {
        if (cells.size() != columns.size()) {
            throw new IllegalArgumentException("A row of " + cells.size() + " cells for a table with " + columns.size()
                    + " columns (" + file + ").");
        }
        writeLine(cells);
    }

    /** Appends the rows of a finished table with the same columns. */
    void append(Path other) throws IOException {
        try (InputStream in = new BufferedInputStream(Files.newInputStream(other))) {
            int next = in.read();
            while (next >= 0 && next != '\n') {
                next = in.read();
            }
            in.transferTo(out);
        }
    }

    /**
     * Completes the table and moves it into place, replacing an older file.
     *
     * @throws IOException if the file cannot be written
     */
    public void finish() throws IOException {
        out.close();
        AtomicFile.moveIntoPlace(file);
    }

    /** Discards the table unless it is finished. */
    @Override
    public void close() throws IOException {
        try {
            out.close();
        } finally {
            Files.deleteIfExists(part);
        }
    }

    private void writeLine(List<Object> cells) throws IOException {
        String line = cells.stream().map(TableFile::text).collect(Collectors.joining(",", "", "\n"));
        out.write(line.getBytes(StandardCharsets.UTF_8));
    }

    private static String text(Object cell) {
        if (cell instanceof Double number && number.isNaN()) {
            return "";
        }
        return cell instanceof Number ? cell.toString() : Csv.cell(cell.toString());
    }
}
