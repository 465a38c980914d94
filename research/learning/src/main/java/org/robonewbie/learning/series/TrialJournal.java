package org.robonewbie.learning.series;

import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.io.Writer;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.security.MessageDigest;
import java.security.NoSuchAlgorithmException;
import java.util.Arrays;
import java.util.HexFormat;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.stream.Collectors;
import java.util.stream.DoubleStream;
import org.robonewbie.nao.file.AtomicFile;

/**
 * Keeps the result of each trial in a file as soon as it is there, so that a series that was broken off goes on where it was. A line that
 * was being written then, or that is damaged, is forgotten: its trial is done again.
 *
 * <pre>{@code
 * try (TrialJournal journal = TrialJournal.open(file, plan)) {
 *     engine.run(plan.experiment(), journal.missing(), "", done -> {}, journal);
 * }
 * }</pre>
 */
public final class TrialJournal implements TrialSink, AutoCloseable {

    private static final String HEAD = "RoboNewbie trials ";

    private final Path file;
    private final List<PlannedTrial> trials;
    private final Map<Integer, double[]> measured;
    private final Map<Integer, String> failures = new TreeMap<>();
    private final Writer writer;

    private TrialJournal(Path file, List<PlannedTrial> trials, Map<Integer, double[]> measured, Writer writer) {
        this.file = file;
        this.trials = trials;
        this.measured = measured;
        this.writer = writer;
    }

    /**
     * Opens a journal; what it has of the same plan is kept.
     *
     * @param file the file; it is made if it is missing
     * @param plan what is to be done
     * @return the journal
     * @throws IOException if the file cannot be read or written; the message says what to do
     * @throws IllegalArgumentException if it belongs to another plan
     */
    public static TrialJournal open(Path file, ExperimentPlan plan) throws IOException {
        String head = HEAD + fingerprint(plan);
        Map<Integer, double[]> measured = new LinkedHashMap<>();
        try {
            if (Files.exists(file)) {
                read(file, head, measured);
            }
            AtomicFile.write(file, head + "\n" + text(measured));
            return new TrialJournal(file, plan.all(), measured, appending(file));
        } catch (IOException unwritable) {
            throw unwritable(file, unwritable);
        }
    }

    private static Writer appending(Path file) throws IOException {
        return Files.newBufferedWriter(file, StandardCharsets.UTF_8, StandardOpenOption.APPEND);
    }

    private static void read(Path file, String head, Map<Integer, double[]> measured) throws IOException {
        String text = Files.readString(file);
        String whole = text.substring(0, text.lastIndexOf('\n') + 1);
        List<String> lines = whole.lines().toList();
        if (lines.isEmpty()) {
            return;
        }
        if (!lines.get(0).equals(head)) {
            throw new IllegalArgumentException("The file " + file
                    + " has trials of another plan, or of another version of its experiment. Delete it, or write to another"
                    + " --output.");
        }
        for (String line : lines.subList(1, lines.size())) {
            read(line, measured);
        }
    }

    private static void read(String line, Map<Integer, double[]> measured) {
        String[] words = line.split(",", -1);
        try {
            int number = Integer.parseInt(words[0]);
            double[] numbers = Arrays.stream(words)
                    .skip(1)
                    .filter(word -> !word.isEmpty())
                    .mapToDouble(Double::parseDouble)
                    .toArray();
            measured.put(number, numbers);
        } catch (NumberFormatException damaged) {
            // The trial counts as missing.
        }
    }

    private static String text(Map<Integer, double[]> measured) {
        return measured.entrySet().stream()
                .map(trial -> line(trial.getKey(), trial.getValue()))
                .collect(Collectors.joining());
    }

    private static String line(int number, double[] numbers) {
        return number + ","
                + DoubleStream.of(numbers).mapToObj(Double::toString).collect(Collectors.joining(",")) + "\n";
    }

    /** {@return the number of trials that are done} */
    public synchronized int done() {
        return measured.size();
    }

    /** {@return the trials that are still to be done} */
    public synchronized List<PlannedTrial> missing() {
        return trials.stream()
                .filter(trial -> !measured.containsKey(trial.number()))
                .toList();
    }

    /** {@return what went wrong, a sentence for each trial that has failed since the journal was opened} */
    public synchronized List<String> failures() {
        return List.copyOf(failures.values());
    }

    @Override
    public synchronized void measured(PlannedTrial trial, double[] numbers) {
        try {
            writer.write(line(trial.number(), numbers));
            writer.flush();
            measured.put(trial.number(), numbers);
        } catch (IOException full) {
            throw new UncheckedIOException(unwritable(file, full));
        }
    }

    @Override
    public synchronized void failed(PlannedTrial trial, String why) {
        failures.put(trial.number(), why);
    }

    /**
     * Makes a table of the trials that are done or have failed, in the order of the plan.
     *
     * @param columns names of the measured numbers
     * @return the table
     */
    public synchronized ResultTable table(List<String> columns) {
        List<PlannedTrial> known = trials.stream()
                .filter(trial -> measured.containsKey(trial.number()) || failures.containsKey(trial.number()))
                .toList();
        return new ResultTable(
                columns,
                known,
                known.stream()
                        .map(trial -> measured.getOrDefault(trial.number(), new double[0]))
                        .toList(),
                Map.copyOf(failures));
    }

    /** Keeps the file, so that the series can go on. */
    @Override
    public void close() {
        try {
            writer.close();
        } catch (IOException full) {
            throw new UncheckedIOException(unwritable(file, full));
        }
    }

    /**
     * Deletes the file, when its table has been written.
     *
     * @throws IOException if that fails
     */
    public void delete() throws IOException {
        close();
        Files.deleteIfExists(file);
    }

    private static IOException unwritable(Path file, IOException cause) {
        return new IOException(
                "The file " + file + " cannot be written (" + cause.getMessage()
                        + "). Make room on the disk, or name another --output; what is there is kept, and the same command goes on.",
                cause);
    }

    /** What the results depend on: the plan and the class of the experiment. */
    private static String fingerprint(ExperimentPlan plan) {
        try {
            MessageDigest digest = MessageDigest.getInstance("SHA-256");
            digest.update(plan.toString().getBytes(StandardCharsets.UTF_8));
            ClassLoader loader = Thread.currentThread().getContextClassLoader();
            String name = plan.experiment().replace('.', '/') + ".class";
            try (InputStream bytes = loader == null ? null : loader.getResourceAsStream(name)) {
                digest.update(bytes == null ? new byte[0] : bytes.readAllBytes());
            }
            return HexFormat.of().formatHex(digest.digest()).substring(0, 16);
        } catch (NoSuchAlgorithmException | IOException impossible) {
            throw new IllegalStateException("The plan cannot be told from others.", impossible);
        }
    }
}
