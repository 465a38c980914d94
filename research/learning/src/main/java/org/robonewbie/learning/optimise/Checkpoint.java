package org.robonewbie.learning.optimise;

import java.io.IOException;
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
import org.robonewbie.trial.batch.Journal;

/**
 * The journal of an optimisation: the costs of all candidates of each generation and, after a bar, its score for display. Since the same
 * costs lead to the same candidates, a search resumes from it exactly. Behind another bar each line has a checksum of the file up to
 * there; lines without one are read too.
 */
final class Checkpoint implements AutoCloseable {

    private static final String BAR = " | ";

    private final Path file;
    private final Journal journal;
    private final CRC32 sum = new CRC32();
    private final List<Line> generations = new ArrayList<>();

    private Checkpoint(Path file, String header) throws IOException {
        this.file = file;
        this.journal = Journal.open(file, header);
        note(header + "\n");
        journal.lines().forEach(this::read);
    }

    /** Begins a new search; an earlier checkpoint is deleted. */
    static Checkpoint begin(Path file, String header) throws IOException {
        Files.deleteIfExists(file);
        return new Checkpoint(file, header);
    }

    /**
     * Opens the checkpoint of an interrupted search.
     *
     * @throws IllegalArgumentException if it belongs to another search or is damaged
     */
    static Checkpoint resume(Path file, String header) throws IOException {
        if (!Files.exists(file)) {
            throw new IllegalArgumentException(
                    "There is nothing to resume: " + file + " does not exist. Leave out --resume.");
        }
        return new Checkpoint(file, header);
    }

    private void read(String text) {
        String[] parts = text.split(Pattern.quote(BAR), -1);
        Line line = line(text, parts);
        String checksum = checksum(line);
        if (parts.length > 2 && !parts[2].equals(checksum)) {
            throw new IllegalArgumentException(
                    file + " is damaged: the checksum of \"" + text + "\" does not fit. Leave out --resume.");
        }
        generations.add(line);
    }

    /** Adds a line to the running checksum and returns the checksum. */
    private String checksum(Line next) {
        note(next.toString());
        String checksum = String.format(Locale.ROOT, "%08x", sum.getValue());
        note(BAR + checksum + "\n");
        return checksum;
    }

    private void note(String text) {
        sum.update(text.getBytes(StandardCharsets.UTF_8));
    }

    /** The generations of earlier runs. */
    List<Line> generations() {
        return List.copyOf(generations);
    }

    void add(double[] costs, Score score) throws IOException {
        Line line = new Line(costs.clone(), score);
        journal.add(line + BAR + checksum(line));
    }

    @Override
    public void close() throws IOException {
        journal.close();
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

    /** The result of one generation. */
    @SuppressWarnings("ArrayRecordComponent")
    record Line(double[] costs, Score score) {

        @Override
        public String toString() {
            return text(costs) + BAR + text(score.best(), score.mean(), score.success());
        }
    }
}
