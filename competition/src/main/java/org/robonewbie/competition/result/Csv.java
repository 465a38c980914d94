package org.robonewbie.competition.result;

import java.util.List;
import java.util.stream.Collectors;
import java.util.stream.Stream;

/** Writes tables as text with commas, quoted where needed (RFC 4180). */
public final class Csv {

    private Csv() {}

    /**
     * Writes one line.
     *
     * @param cells what stands in it
     * @return the line without its end
     */
    public static String line(Stream<String> cells) {
        return cells.map(cell -> cell.matches("(?s).*[,\"\\r\\n].*") ? "\"" + cell.replace("\"", "\"\"") + "\"" : cell)
                .collect(Collectors.joining(","));
    }

    /**
     * Joins lines to a table.
     *
     * @param lines the lines, the first one with the names of the columns
     * @return the text of a file
     */
    public static String text(List<String> lines) {
        return lines.stream().map(line -> line + "\r\n").collect(Collectors.joining());
    }
}
