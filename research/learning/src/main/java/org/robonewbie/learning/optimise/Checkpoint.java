package org.robonewbie.learning.optimise;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import java.util.zip.CRC32;
import org.robonewbie.learning.optimise.Generation.Score;
import org.robonewbie.nao.file.AtomicFile;

/**
 * The memory of an optimisation: what it searches for, and in each line the costs of all candidates of a generation and, after
 * a bar, its score for people. Since the same costs lead to the same candidates, this is all it takes to continue exactly where
 * it was interrupted. The file is rewritten after each generation, atomically. Behind another bar each line has a checksum of itself and
 * all that stands before it, so that a damaged number is not taken for a true one; lines without one are read too.
 */
final class Checkpoint {

    private static final String BAR = " | ";

    private final Path file;
    private final List<Line> generations = new ArrayList<>();
    private final StringBuilder content;

    private Checkpoint(Path file, String question) {
        this.file = file;
        this.content = new StringBuilder(question).append('\n');
    }

    /** Begins with nothing. */
    static Checkpoint begin(Path file, String question) {
        return new Checkpoint(file, question);
    }

    /**
     * Remembers what was reached before.
     *
     * @throws IllegalArgumentException if the file belongs to another optimisation or cannot be understood
     */
    static Checkpoint resume(Path file, String question) throws IOException {
        if (!Files.exists(file)) {
            throw new IllegalArgumentException(
                    "There is nothing to resume: " + file + " does not exist. Leave out --resume.");
        }
        List<String> lines = Files.readAllLines(file, StandardCharsets.UTF_8);
        if (lines.isEmpty() || !lines.get(0).equals(question)) {
            throw new IllegalArgumentException(file + " belongs to another optimisation:\n  "
                    + (lines.isEmpty() ? "(empty file)" : lines.get(0)) + "\nand not to:\n  " + question
                    + "\nGive the same options as before, or leave out --resume.");
        }
        Checkpoint checkpoint = new Checkpoint(file, question);
        lines.stream().skip(1).forEach(checkpoint::read);
        return checkpoint;
    }

    private void read(String text) {
        String[] parts = text.split(Pattern.quote(BAR), -1);
        Line line = line(text, parts);
        if (parts.length > 2 && !parts[2].equals(checksum(line))) {
            throw new IllegalArgumentException(
                    file + " is damaged: the checksum of \"" + text + "\" does not fit. Leave out --resume.");
        }
        keep(line);
    }

    private void keep(Line line) {
        String checksum = checksum(line);
        content.append(line).append(BAR).append(checksum).append('\n');
        generations.add(line);
    }

    private String checksum(Line next) {
        CRC32 sum = new CRC32();
        sum.update((content.toString() + next).getBytes(StandardCharsets.UTF_8));
        return String.format(Locale.ROOT, "%08x", sum.getValue());
    }

    /** All generations so far. */
    List<Line> generations() {
        return List.copyOf(generations);
    }

    /** Adds a generation and writes the file. */
    void add(double[] costs, Score score) {
        keep(new Line(costs.clone(), score));
        try {
            AtomicFile.write(file, content.toString());
        } catch (IOException e) {
            throw new UncheckedIOException("Cannot write " + file + ".", e);
        }
    }

    private Line line(String text, String... parts) {
        try {
            double[] score = numbers(parts[1]);
            return new Line(numbers(parts[0]), new Score(score[0], score[1], score[2]));
        } catch (NumberFormatException | ArrayIndexOutOfBoundsException e) {
            throw new IllegalArgumentException(
                    file + " cannot be understood: \"" + text + "\". Leave out --resume.", e);
        }
    }

    private static double[] numbers(String text) {
        return Arrays.stream(text.split(" ", -1))
                .mapToDouble(Double::parseDouble)
                .toArray();
    }

    private static String text(double... numbers) {
        return Arrays.stream(numbers).mapToObj(Double::toString).collect(Collectors.joining(" "));
    }

    /** What is known of one generation. */
    @SuppressWarnings("ArrayRecordComponent")
    record Line(double[] costs, Score score) {

        @Override
        public String toString() {
            return text(costs) + BAR + text(score.best(), score.mean(), score.success());
        }
    }
}
