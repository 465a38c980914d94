package org.robonewbie.nao.text;

import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import java.util.List;
import java.util.Objects;
import java.util.stream.Stream;

/** A table of the test resources, which the tests of the pages' scripts read as well: cells between tabs, with escapes as in Java. */
final class Table {

    private Table() {}

    static Stream<List<String>> rows(String file) {
        try (InputStream in = Objects.requireNonNull(Table.class.getResourceAsStream(file))) {
            return new String(in.readAllBytes(), StandardCharsets.UTF_8)
                            .lines()
                            .filter(line -> !line.startsWith("# "))
                            .map(line -> Arrays.stream(line.split("\t", -1))
                                    .map(Table::unescaped)
                                    .toList())
                            .toList()
                            .stream();
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    private static String unescaped(String cell) {
        StringBuilder text = new StringBuilder();
        for (int i = 0; i < cell.length(); i++) {
            if (cell.charAt(i) != '\\') {
                text.append(cell.charAt(i));
            } else if (cell.charAt(++i) == 'u') {
                text.append((char) Integer.parseInt(cell.substring(i + 1, i + 5), 16));
                i += 4;
            } else {
                text.append("\\\n\r\t".charAt("\\nrt".indexOf(cell.charAt(i))));
            }
        }
        return text.toString();
    }
}
