package org.robonewbie.nao.text;

import java.util.List;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import java.util.stream.Stream;

/**
 * Writes tables as text with commas, quoted where needed (RFC 4180). A text that a spreadsheet would take for a formula gets an
 * apostrophe before it; numbers stay as they are.
 */
public final class Csv {

    private static final Pattern NUMBER = Pattern.compile("\\s*[+-]?(?:\\d+\\.?\\d*|\\.\\d+)(?:[eE][+-]?\\d+)?\\s*");

    /** Also behind blanks, and as the wide forms that some spreadsheets read alike. */
    private static final Pattern FORMULA =
            Pattern.compile("(?s)[\\t\\r\\n].*|[\\s\\p{Cc}\\p{Cf}\\p{Z}]*[=+\\-@＝＋－＠].*");

    private static final Pattern QUOTED = Pattern.compile("(?s).*[,\"\\r\\n].*");

    private Csv() {}

    /**
     * Writes one cell.
     *
     * @param text what stands in it
     * @return the cell
     */
    public static String cell(String text) {
        boolean isFormula =
                FORMULA.matcher(text).matches() && !NUMBER.matcher(text).matches();
        String safe = isFormula ? "'" + text : text;
        return QUOTED.matcher(safe).matches() ? "\"" + safe.replace("\"", "\"\"") + "\"" : safe;
    }

    /**
     * Writes one line.
     *
     * @param cells what stands in it
     * @return the line without its end
     */
    public static String line(Stream<String> cells) {
        return cells.map(Csv::cell).collect(Collectors.joining(","));
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
