package org.robonewbie.learning.dataset;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Comparator;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.Set;
import java.util.TreeSet;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import org.robonewbie.nao.file.AtomicFile;

/**
 * Folder of files with the tables of single runs ({@code run-00001.csv}) or of consecutive runs ({@code run-00001-to-00010.csv}).
 *
 * @param folder the folder
 */
record RunFiles(Path folder) {

    private static final Pattern NAME = Pattern.compile("run-(\\d+)(?:-to-(\\d+))?\\.csv");

    /** A file with the tables of consecutive runs. */
    private record Span(Path file, int first, int last) {}

    Path of(int run) {
        return folder.resolve(String.format(Locale.ROOT, "run-%05d.csv", run));
    }

    private Path of(int first, int last) {
        return folder.resolve(String.format(Locale.ROOT, "run-%05d-to-%05d.csv", first, last));
    }

    /** Returns the numbers of all runs that have tables. */
    Set<Integer> present() throws IOException {
        return spans().stream()
                .flatMap(span -> IntStream.rangeClosed(span.first, span.last).boxed())
                .collect(Collectors.toCollection(TreeSet::new));
    }

    /** Deletes the unfinished file of a run that was interrupted. */
    void discard(int run) throws IOException {
        Files.deleteIfExists(AtomicFile.part(of(run)));
    }

    /** Joins the tables of consecutive runs into one file. An interrupted call can be repeated. */
    void join(int first, int last, List<Column> columns) throws IOException {
        List<Span> parts = spans().stream()
                .filter(span -> span.first >= first && span.last <= last)
                .toList();
        Path joined = of(first, last);
        if (!Files.exists(joined)) {
            try (TableFile table = new TableFile(joined, columns)) {
                append(table, parts);
                table.finish();
            }
        }
        for (Span part : parts) {
            if (!part.file.equals(joined)) {
                Files.delete(part.file);
            }
        }
    }

    private static void append(TableFile table, List<Span> parts) throws IOException {
        int done = 0;
        for (Span part : parts) {
            if (part.first > done) {
                table.append(part.file);
                done = part.last;
            }
        }
    }

    /**
     * Returns the files in the order of their first runs. Among files with the same first run, the one with the most
     * runs comes first.
     */
    private List<Span> spans() throws IOException {
        try (Stream<Path> files = Files.list(folder)) {
            return files.map(this::span)
                    .flatMap(Optional::stream)
                    .sorted(Comparator.comparingInt(Span::first).thenComparing(Span::last, Comparator.reverseOrder()))
                    .toList();
        }
    }

    private Optional<Span> span(Path file) {
        Matcher name = NAME.matcher(file.getFileName().toString());
        if (!name.matches()) {
            return Optional.empty();
        }
        int first = Integer.parseInt(name.group(1));
        return Optional.of(new Span(file, first, name.group(2) == null ? first : Integer.parseInt(name.group(2))));
    }
}
