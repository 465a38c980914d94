package org.robonewbie.learning.search;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.stream.Collectors;
import org.robonewbie.nao.file.AtomicFile;
import org.robonewbie.nao.file.TextFile;
import org.robonewbie.nao.file.UnreadableFileException;

/** A file with the coordinates that a search has found so far: numbers with commas between them. */
public final class SearchFile {

    private SearchFile() {}

    /**
     * Goes on with a search from a file, prints what each generation has found, and keeps it in the file.
     *
     * @param file the file
     * @param first where the search starts if there is no file yet
     * @param search the search
     * @throws IOException if the file cannot be read, or has other numbers than the search; the message names the line
     * @throws UncheckedIOException if it cannot be written
     */
    public static void goOn(Path file, double[] first, Search search) throws IOException {
        search.run(Files.exists(file) ? read(file, first.length) : first, progress -> {
            System.out.println(progress);
            write(progress.mean(), file);
        });
    }

    private static double[] read(Path file, int count) throws IOException {
        List<String> lines = TextFile.readAndNote(file).lines();
        List<Double> numbers = new ArrayList<>();
        for (int i = 0; i < lines.size(); i++) {
            for (String word : lines.get(i).trim().split("[, ]+", -1)) {
                if (!word.isEmpty()) {
                    numbers.add(number(word, file, i + 1));
                }
            }
        }
        if (numbers.size() != count) {
            throw UnreadableFileException.atLine(
                    file,
                    Math.max(1, lines.size()),
                    "There are " + numbers.size() + " numbers, and the search has " + count
                            + ". Delete the file to begin again, or name another one.");
        }
        return numbers.stream().mapToDouble(Double::doubleValue).toArray();
    }

    private static double number(String word, Path file, int line) throws IOException {
        try {
            return Double.parseDouble(word);
        } catch (NumberFormatException none) {
            throw UnreadableFileException.atLine(file, line, "\"" + word + "\" is no number.");
        }
    }

    private static void write(double[] coordinates, Path file) {
        String text = Arrays.stream(coordinates)
                .mapToObj(x -> String.format(Locale.ROOT, "%.3f", x))
                .collect(Collectors.joining(", ", "", "\n"));
        try {
            AtomicFile.write(file, text);
        } catch (IOException cause) {
            throw new UncheckedIOException("The coordinates cannot be kept in " + file + ".", cause);
        }
    }
}
