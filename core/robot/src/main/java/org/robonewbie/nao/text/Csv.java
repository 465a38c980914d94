package org.robonewbie.nao.text;

import java.util.List;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import java.util.stream.Stream;

/**
 * Writes tables as comma-separated values (RFC 4180). Text that a spreadsheet would evaluate as a formula is prefixed with an
 * apostrophe.
 */
public final class Csv {

    private static final Pattern NUMBER = Pattern.compile("\\s*[+-]?(?:\\d+\\.?\\d*|\\.\\d+)(?:[eE][+-]?\\d+)?\\s*");

    /** Start of a formula, including after white space and in the full-width forms that some spreadsheets accept. */
    private static final Pattern FORMULA =
            Pattern.compile("(?s)[\\t\\r\\n].*|[\\s\\p{Cc}\\p{Cf}\\p{Z}]*[=+\\-@＝＋－＠].*");

    private static final Pattern QUOTED = Pattern.compile("(?s).*[,\"\\r\\n].*");

    private Csv() {}

    /**
     * Formats a cell.
     *
     * @param text the text of the cell
     * @return the cell, quoted if necessary
     */
    public static String cell(String text) {
        boolean isFormula =
                FORMULA.matcher(text).matches() && !NUMBER.matcher(text).matches();
        String safe = isFormula ? "'" + text : text;
        return QUOTED.matcher(safe).matches() ? "\"" + safe.replace("\"", "\"\"") + "\"" : safe;
    }

    /**
     * Formats a line.
     *
     * @param cells the text of each cell
     * @return the line without its line terminator
     */
    public static String line(Stream<String> cells) {
        // In the web edition, Collectors.joining drops an empty first cell.
        return String.join(",", cells.map(Csv::cell).toList());
    }

    /**
     * Joins lines into a table.
     *
     * @param lines the lines, beginning with the header
     * @return the text of the file
     */
    public static String text(List<String> lines) {
        return lines.stream().map(line -> line + "\r\n").collect(Collectors.joining());
    }
}
