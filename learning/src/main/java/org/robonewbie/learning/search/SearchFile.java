package org.robonewbie.learning.search;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.Locale;
import java.util.stream.Collectors;
import org.robonewbie.nao.file.AtomicFile;

/** A file with the coordinates that a search has found so far: numbers with commas between them. */
public final class SearchFile {

    private SearchFile() {}

    /**
     * Goes on with a search from a file, prints what each generation has found, and keeps it in the file.
     *
     * @param file the file
     * @param first where the search starts if there is no file yet
     * @param search the search
     * @throws IOException if the file cannot be read
     * @throws UncheckedIOException if it cannot be written
     */
    public static void goOn(Path file, double[] first, Search search) throws IOException {
        search.run(Files.exists(file) ? read(file) : first, progress -> {
            System.out.println(progress);
            write(progress.mean(), file);
        });
    }

    private static double[] read(Path file) throws IOException {
        String[] words = Files.readString(file).trim().split("[, ]+");
        return Arrays.stream(words).mapToDouble(Double::parseDouble).toArray();
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
