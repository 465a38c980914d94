package org.robonewbie.workshop.fidelity;

import com.google.gson.GsonBuilder;
import com.google.gson.JsonNull;
import com.google.gson.JsonPrimitive;
import com.google.gson.JsonSerializer;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.OptionalDouble;
import java.util.function.Function;

/**
 * Results of the fidelity bench.
 *
 * @param recordings one entry per recording, in alphabetical order
 * @param problems one sentence for each file that could not be replayed
 */
public record FidelityReport(List<RecordingFidelity> recordings, List<String> problems) {

    private static final List<Column> COLUMNS = List.of(
            new Column("joints med", "%.4f", 1, RecordingFidelity::jointMedianDegrees),
            new Column("max °", "%.4f", 1, RecordingFidelity::jointMaxDegrees),
            new Column("torso med", "%.4f", 1000, RecordingFidelity::torsoMedianMetres),
            new Column("max mm", "%.4f", 1000, RecordingFidelity::torsoMaxMetres),
            new Column("max °", "%.4f", 1, RecordingFidelity::torsoMaxDegrees),
            new Column("ball mm", "%.4f", 1000, RecordingFidelity::ballMaxMetres),
            new Column("ACC %", "%.2f", 100, RecordingFidelity::accRowsEqual),
            new Column("GYR %", "%.2f", 100, RecordingFidelity::gyrRowsEqual),
            new Column("FRP %", "%.2f", 100, RecordingFidelity::frpRowsEqual),
            new Column("rest mm", "%.4f", 1000, RecordingFidelity::restMetres),
            new Column("rest °", "%.4f", 1, RecordingFidelity::restDegrees),
            new Column("differs s", "%.2f", 1, RecordingFidelity::firstDivergenceSeconds));

    private record Column(
            String heading, String format, double factor, Function<RecordingFidelity, OptionalDouble> value) {

        String cell(RecordingFidelity recording) {
            OptionalDouble number = value.apply(recording);
            return number.isPresent() ? String.format(Locale.ROOT, format, number.getAsDouble() * factor) : "-";
        }
    }

    /** Stores unmodifiable copies of the lists. */
    public FidelityReport {
        recordings = List.copyOf(recordings);
        problems = List.copyOf(problems);
    }

    /**
     * Formats the results for the console.
     *
     * @return a table with a row per recording, lengths in millimetres
     */
    public String toTable() {
        int nameWidth =
                recordings.stream().mapToInt(r -> r.name().length()).max().orElse(0);
        StringBuilder table = new StringBuilder();
        appendRow(table, nameWidth, "", Column::heading);
        recordings.forEach(
                recording -> appendRow(table, nameWidth, recording.name(), column -> column.cell(recording)));
        return table.toString();
    }

    private static void appendRow(StringBuilder table, int nameWidth, String name, Function<Column, String> cell) {
        table.append(name).append(" ".repeat(nameWidth - name.length()));
        COLUMNS.forEach(column -> table.append(String.format(Locale.ROOT, " %10s", cell.apply(column))));
        table.append('\n');
    }

    /**
     * Formats the results as JSON: {@code {"recordings":[{"name":…,"jointMedianDegrees":…,…}]}}. Values that a recording does
     * not contain are null. {@code "problems":["…"]} is present only if there are problems.
     *
     * @return JSON text
     */
    public String toJson() {
        Map<String, Object> all = new LinkedHashMap<>();
        all.put("recordings", recordings);
        if (!problems.isEmpty()) {
            all.put("problems", problems);
        }
        JsonSerializer<OptionalDouble> nullIfUnknown = (value, type, context) ->
                Double.isFinite(value.orElse(Double.NaN)) ? new JsonPrimitive(value.getAsDouble()) : JsonNull.INSTANCE;
        return new GsonBuilder()
                        .registerTypeAdapter(OptionalDouble.class, nullIfUnknown)
                        .serializeNulls()
                        .setPrettyPrinting()
                        .create()
                        .toJson(all)
                + "\n";
    }
}
