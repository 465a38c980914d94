package org.robonewbie.workshop;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.regex.MatchResult;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import java.util.stream.Stream;

/**
 * A table in a page of the documentation between two comments.
 *
 * @param page the page
 * @param label the first comment, which says where the table comes from
 * @param text the lines between the comments
 */
record PageTable(Path page, String label, String text) {

    /** Folder of the pages. */
    static final Path DOCS = Path.of("..", "docs");

    private static final Pattern TABLE =
            Pattern.compile("(?s)<!-- ((?:generated|measured): [^\\n]*?) -->\\n\\n(.*?)\\n\\n<!-- end -->");

    /** Returns the tables whose first comment begins with a text, in all pages. */
    static List<PageTable> all(String label) throws IOException {
        return pages().stream()
                .flatMap(page -> TABLE.matcher(read(page)).results().map(found -> of(page, found)))
                .filter(table -> table.label().startsWith(label))
                .toList();
    }

    /** Returns the text of all pages without these tables. */
    static String textOutsideTables() throws IOException {
        return pages().stream()
                .map(page -> TABLE.matcher(read(page)).replaceAll(""))
                .collect(Collectors.joining());
    }

    private static List<Path> pages() throws IOException {
        try (Stream<Path> files = Files.walk(DOCS)) {
            return files.filter(file -> file.toString().endsWith(".md"))
                    .sorted()
                    .toList();
        }
    }

    private static PageTable of(Path page, MatchResult found) {
        return new PageTable(page, found.group(1), found.group(2));
    }

    /** Returns the rows below the header. */
    List<String> rows() {
        return text.lines().skip(2).toList();
    }

    /** Writes another table into the page. */
    void replace(String table) throws IOException {
        String before = "<!-- " + label + " -->\n\n";
        Files.writeString(page, read(page).replace(before + text, before + table));
    }

    static String read(Path page) {
        try {
            return Files.readString(page);
        } catch (IOException unreadable) {
            throw new UncheckedIOException(unreadable);
        }
    }
}
