package org.robonewbie.learning.dataset;

import java.io.BufferedInputStream;
import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Collectors;
import org.robonewbie.nao.text.Csv;

/** A table of comma-separated values as in RFC 4180, in UTF-8 with lines that end with a line feed. */
final class CsvFile extends TableFile {

    CsvFile(Path file, List<Column> columns) throws IOException {
        super(file, columns);
        writeLine(columns.stream().<Object>map(Column::name).toList());
    }

    @Override
    void write(List<Object> cells) throws IOException {
        writeLine(cells);
    }

    @Override
    void append(Path other) throws IOException {
        try (InputStream in = new BufferedInputStream(Files.newInputStream(other))) {
            int next = in.read();
            while (next >= 0 && next != '\n') {
                next = in.read();
            }
            in.transferTo(out());
        }
    }

    @Override
    void writeEnd() {}

    private void writeLine(List<Object> cells) throws IOException {
        String line = cells.stream().map(CsvFile::text).collect(Collectors.joining(",", "", "\n"));
        out().write(line.getBytes(StandardCharsets.UTF_8));
    }

    private static String text(Object cell) {
        if (cell instanceof Double number && number.isNaN()) {
            return "";
        }
        return cell instanceof Number ? cell.toString() : Csv.cell(cell.toString());
    }
}
