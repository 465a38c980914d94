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
 * Journal of an optimisation. Each line holds the costs of the candidates of a generation, the score of the generation
 * for display, and a CRC-32 of the file up to that point, separated by vertical bars; the checksum is optional. The
 * costs determine the next candidates, so a search resumes exactly where it was interrupted.
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
        updateSum(header + "\n");
        journal.lines().forEach(this::read);
    }

    /** Begins a new search and deletes any earlier checkpoint. */
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
                    "There is nothing to resume: " + file + " does not exist. Omit --resume to start a new search.");
        }
        return new Checkpoint(file, header);
    }

    private void read(String text) {
        String[] parts = text.split(Pattern.quote(BAR), -1);
        Line line = line(text, parts);
        String checksum = checksum(line);
        if (parts.length > 2 && !parts[2].equals(checksum)) {
            throw new IllegalArgumentException(file + " is damaged: the checksum of \"" + text
                    + "\" does not match. Omit --resume to start again.");
        }
        generations.add(line);
    }

    /** Adds a line to the running checksum and returns the checksum. */
    private String checksum(Line next) {
        updateSum(next.toString());
        String checksum = String.format(Locale.ROOT, "%08x", sum.getValue());
        updateSum(BAR + checksum + "\n");
        return checksum;
    }

    private void updateSum(String text) {
        sum.update(text.getBytes(StandardCharsets.UTF_8));
    }

    /** Returns the generations recorded before the interruption. */
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
                    file + " is damaged at \"" + text + "\". Omit --resume to start again.", e);
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

    @SuppressWarnings("ArrayRecordComponent")
    record Line(double[] costs, Score score) {

        @Override
        public String toString() {
            return text(costs) + BAR + text(score.best(), score.mean(), score.success());
        }
    }
}
