package org.robonewbie.app.command;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.Locale;
import java.util.stream.Collectors;
import org.robonewbie.learning.search.CostFunction;
import org.robonewbie.learning.search.Search;
import org.robonewbie.learning.search.SearchPlan;
import org.robonewbie.team.skill.CloseDribble;
import org.robonewbie.team.skill.CloseDribbleNumbers;

/** The search for the numbers of {@link CloseDribble}: those of its walk and those of its touches together. */
public final class DribbleDesign implements CostFunction {

    private static final SearchPlan PLAN = new SearchPlan(5, 0.2, 12, 60, 6, 2);

    /** Prepares the search. */
    DribbleDesign() {}

    /**
     * Goes on with the search from a file, or from the shipped numbers, and writes what it finds into that file after each generation.
     *
     * @param arguments the file with the coordinates
     * @throws IOException if the file cannot be read or written
     */
    public static void main(String[] arguments) throws IOException {
        Path file = Path.of(arguments[0]);
        double[] start = Files.exists(file) ? read(file) : CloseDribbleNumbers.coordinates();
        new Search(PLAN, new DribbleDesign()).run(start, progress -> {
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
            Files.writeString(file, text);
        } catch (IOException cause) {
            throw new UncheckedIOException("The coordinates cannot be kept in " + file + ".", cause);
        }
    }

    @Override
    public double cost(double[] x, long seed) {
        return DribbleTrial.direct(CloseDribbleNumbers.of(x), seed).cost();
    }
}
