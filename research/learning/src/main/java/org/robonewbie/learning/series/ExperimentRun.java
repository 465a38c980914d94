package org.robonewbie.learning.series;

import java.io.IOException;
import java.io.InputStream;
import java.io.Serializable;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.security.MessageDigest;
import java.security.NoSuchAlgorithmException;
import java.util.Arrays;
import java.util.HashMap;
import java.util.HexFormat;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.stream.Collectors;
import java.util.stream.DoubleStream;
import org.robonewbie.trial.batch.BatchProgress;
import org.robonewbie.trial.batch.BatchRunner;
import org.robonewbie.trial.batch.Journal;

/**
 * Run of all trials of a plan. A journal records the values of each trial as soon as they are known, so an interrupted run can resume. A
 * trial whose line is damaged is run again.
 *
 * <pre>{@code
 * try (ExperimentRun run = ExperimentRun.open(file, plan)) {
 *     run.run(runner, progress);
 *     run.table(columns).write(output);
 * }
 * }</pre>
 */
public final class ExperimentRun implements AutoCloseable {

    private final ExperimentPlan plan;
    private final List<PlannedTrial> trials;
    private final Journal journal;
    private final Map<Integer, double[]> measured = new HashMap<>();
    private final Map<Integer, String> failures = new TreeMap<>();

    private ExperimentRun(ExperimentPlan plan, Journal journal) {
        this.plan = plan;
        this.trials = plan.all();
        this.journal = journal;
        journal.lines().forEach(this::read);
    }

    /**
     * Opens the run of a plan and loads its journal.
     *
     * @param file the journal, which is created if it is missing
     * @param plan the plan
     * @return the run
     * @throws IOException if the file cannot be read or written
     * @throws IllegalArgumentException if the journal belongs to another plan or to another version of the experiment
     */
    public static ExperimentRun open(Path file, ExperimentPlan plan) throws IOException {
        return new ExperimentRun(plan, Journal.open(file, "RoboNewbie trials " + fingerprint(plan)));
    }

    private void read(String line) {
        String[] words = line.split(",", -1);
        try {
            int number = Integer.parseInt(words[0]);
            measured.put(
                    number,
                    Arrays.stream(words)
                            .skip(1)
                            .filter(word -> !word.isEmpty())
                            .mapToDouble(Double::parseDouble)
                            .toArray());
        } catch (NumberFormatException damaged) {
            // The trial is run again.
        }
    }

    /** {@return the trials that have not been run yet} */
    public List<PlannedTrial> missing() {
        return trials.stream()
                .filter(trial -> !measured.containsKey(trial.number()))
                .toList();
    }

    /**
     * Runs the missing trials.
     *
     * @param runner the runner
     * @param progress receives the progress of the run
     * @throws IOException if the journal cannot be written
     */
    public void run(BatchRunner runner, BatchProgress progress) throws IOException {
        String experiment = plan.experiment();
        runner.run(missing(), trial -> trial.run(Experiment.of(experiment)), (trial, outcome) -> {
            add(trial.number(), outcome);
            progress.advance(!outcome.failure.isEmpty());
        });
    }

    private void add(int number, Outcome outcome) throws IOException {
        if (outcome.failure.isEmpty()) {
            journal.add(number + ","
                    + DoubleStream.of(outcome.numbers)
                            .mapToObj(Double::toString)
                            .collect(Collectors.joining(",")));
            measured.put(number, outcome.numbers);
        } else {
            failures.put(number, outcome.failure);
        }
    }

    /** {@return the reason for each failed trial} */
    public List<String> failures() {
        return List.copyOf(failures.values());
    }

    /**
     * Creates the table of the completed and failed trials, in the order of the plan.
     *
     * @param columns names of the measured values
     * @return the table
     */
    public ResultTable table(List<String> columns) {
        List<PlannedTrial> known = trials.stream()
                .filter(trial -> measured.containsKey(trial.number()) || failures.containsKey(trial.number()))
                .toList();
        List<double[]> numbers = known.stream()
                .map(trial -> measured.getOrDefault(trial.number(), new double[0]))
                .toList();
        return new ResultTable(columns, known, numbers, Map.copyOf(failures));
    }

    /** Closes the journal, from which the run can resume. */
    @Override
    public void close() throws IOException {
        journal.close();
    }

    /**
     * Deletes the journal. Call after the table has been written.
     *
     * @throws IOException if the file cannot be deleted
     */
    public void delete() throws IOException {
        journal.delete();
    }

    /** Returns a hash of everything that determines the results: the plan and the class of the experiment. */
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
            throw new IllegalStateException("The plan has no fingerprint.", impossible);
        }
    }

    /**
     * Outcome of a trial.
     *
     * @param numbers the measured values; none if the trial failed
     * @param failure the reason for the failure, as a sentence that identifies the trial; empty if the trial did not fail
     */
    @SuppressWarnings("ArrayRecordComponent")
    record Outcome(double[] numbers, String failure) implements Serializable {}
}
