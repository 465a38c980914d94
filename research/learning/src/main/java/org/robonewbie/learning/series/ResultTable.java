package org.robonewbie.learning.series;

import com.google.gson.stream.JsonWriter;
import java.io.IOException;
import java.io.StringWriter;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.stream.Collectors;
import java.util.stream.DoubleStream;
import org.robonewbie.nao.file.AtomicFile;
import org.robonewbie.nao.text.Csv;

/**
 * Results of a series: the number, seed, parameters and measured values of each trial. If any trials failed, an
 * additional column contains the reasons.
 *
 * @param columns names of the measured values
 * @param trials the trials, ordered by number
 * @param measured the values of each trial, empty if it failed; not to be modified
 * @param failures reasons for failures, by trial number
 */
public record ResultTable(
        List<String> columns, List<PlannedTrial> trials, List<double[]> measured, Map<Integer, String> failures) {

    private static final String FAILURE = "failure";

    /**
     * Writes the table to a file, as JSON if the file name ends with .json, otherwise as CSV.
     *
     * @param file the file, which is replaced atomically
     * @throws IOException if the file cannot be written
     */
    public void write(Path file) throws IOException {
        AtomicFile.write(file, file.toString().endsWith(".json") ? json() : csv());
    }

    /** {@return the table as comma-separated values with a header} */
    public String csv() {
        StringBuilder text = new StringBuilder(String.join(",", names())).append('\n');
        for (int i = 0; i < trials.size(); i++) {
            PlannedTrial trial = trials.get(i);
            text.append(trial.number()).append(',').append(trial.seed());
            trial.all().values().forEach(value -> text.append(',').append(Csv.cell(String.valueOf(value))));
            text.append(results(trial, measured.get(i))).append('\n');
        }
        return text.toString();
    }

    private String results(PlannedTrial trial, double... numbers) {
        String failure = failures.get(trial.number());
        String cells = failure == null
                ? DoubleStream.of(numbers).mapToObj(number -> "," + number).collect(Collectors.joining())
                : ",".repeat(columns.size());
        return failures.isEmpty() ? cells : cells + "," + (failure == null ? "" : Csv.cell(failure));
    }

    private List<String> names() {
        List<String> names = new ArrayList<>(List.of("trial", "seed"));
        if (!trials.isEmpty()) {
            names.addAll(trials.get(0).all().keySet());
        }
        names.addAll(columns);
        if (!failures.isEmpty()) {
            names.add(FAILURE);
        }
        return names.stream().map(Csv::cell).toList();
    }

    /**
     * Returns the table as JSON.
     *
     * @return a list with an object for each trial
     * @throws IOException never
     */
    public String json() throws IOException {
        StringWriter text = new StringWriter();
        try (JsonWriter writer = new JsonWriter(text)) {
            writer.setIndent(" ");
            writer.setStrictness(com.google.gson.Strictness.LENIENT);
            writer.beginArray();
            for (int i = 0; i < trials.size(); i++) {
                write(writer, trials.get(i), measured.get(i));
            }
            writer.endArray();
        }
        return text.append('\n').toString();
    }

    private void write(JsonWriter writer, PlannedTrial trial, double[] numbers) throws IOException {
        writer.beginObject().name("trial").value(trial.number()).name("seed").value(trial.seed());
        for (var parameter : trial.parameters().entrySet()) {
            writer.name(parameter.getKey()).value(parameter.getValue());
        }
        for (var text : trial.texts().entrySet()) {
            writer.name(text.getKey()).value(text.getValue());
        }
        for (int i = 0; i < numbers.length; i++) {
            writer.name(columns.get(i)).value(numbers[i]);
        }
        if (failures.containsKey(trial.number())) {
            writer.name(FAILURE).value(failures.get(trial.number()));
        }
        writer.endObject();
    }
}
