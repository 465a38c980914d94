package org.robonewbie.workshop.fidelity;

import com.google.gson.GsonBuilder;
import com.google.gson.JsonArray;
import com.google.gson.JsonNull;
import com.google.gson.JsonObject;
import com.google.gson.JsonPrimitive;
import java.util.List;
import java.util.Locale;
import java.util.OptionalDouble;

/**
 * Results of the fidelity bench.
 *
 * @param recordings one entry per recording, in alphabetical order
 * @param problems one sentence for each file that could not be replayed
 */
public record FidelityReport(List<RecordingFidelity> recordings, List<String> problems) {

    private static final String[] COLUMNS = {
        "joints med",
        "max °",
        "torso med",
        "max mm",
        "max °",
        "ball mm",
        "ACC %",
        "GYR %",
        "FRP %",
        "rest mm",
        "rest °",
        "differs s"
    };

    /** Copies the lists. */
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
        StringBuilder table = new StringBuilder();
        int nameWidth =
                recordings.stream().mapToInt(r -> r.name().length()).max().orElse(0);
        table.append(" ".repeat(nameWidth));
        for (String column : COLUMNS) {
            table.append(String.format(Locale.ROOT, " %10s", column));
        }
        table.append('\n');
        recordings.forEach(recording -> appendLine(table, nameWidth, recording));
        return table.toString();
    }

    /**
     * Formats the results as JSON: {@code {"recordings":[{"name":…,"jointMedianDegrees":…,…}]}}. Values that a recording does
     * not contain are null. {@code "problems":["…"]} is present only if there are problems.
     *
     * @return JSON text
     */
    public String toJson() {
        JsonArray list = new JsonArray();
        recordings.forEach(recording -> list.add(json(recording)));
        JsonObject all = new JsonObject();
        all.add("recordings", list);
        if (!problems.isEmpty()) {
            JsonArray sentences = new JsonArray();
            problems.forEach(sentences::add);
            all.add("problems", sentences);
        }
        return new GsonBuilder().serializeNulls().setPrettyPrinting().create().toJson(all) + "\n";
    }

    private static void appendLine(StringBuilder table, int nameWidth, RecordingFidelity r) {
        table.append(r.name()).append(" ".repeat(nameWidth - r.name().length()));
        append(table, "%.4f", r.jointMedianDegrees(), 1);
        append(table, "%.4f", r.jointMaxDegrees(), 1);
        append(table, "%.4f", r.torsoMedianMetres(), 1000);
        append(table, "%.4f", r.torsoMaxMetres(), 1000);
        append(table, "%.4f", r.torsoMaxDegrees(), 1);
        append(table, "%.4f", r.ballMaxMetres(), 1000);
        append(table, "%.2f", r.accRowsEqual(), 100);
        append(table, "%.2f", r.gyrRowsEqual(), 100);
        append(table, "%.2f", r.frpRowsEqual(), 100);
        append(table, "%.4f", r.restMetres(), 1000);
        append(table, "%.4f", r.restDegrees(), 1);
        append(table, "%.2f", r.firstDivergenceSeconds(), 1);
        table.append('\n');
    }

    private static void append(StringBuilder table, String format, OptionalDouble value, double factor) {
        String text = value.isPresent() ? String.format(Locale.ROOT, format, value.getAsDouble() * factor) : "-";
        table.append(String.format(Locale.ROOT, " %10s", text));
    }

    private static JsonObject json(RecordingFidelity r) {
        JsonObject object = new JsonObject();
        object.addProperty("name", r.name());
        add(object, "jointMedianDegrees", r.jointMedianDegrees());
        add(object, "jointMaxDegrees", r.jointMaxDegrees());
        add(object, "torsoMedianMetres", r.torsoMedianMetres());
        add(object, "torsoMaxMetres", r.torsoMaxMetres());
        add(object, "torsoMaxDegrees", r.torsoMaxDegrees());
        add(object, "ballMaxMetres", r.ballMaxMetres());
        add(object, "accRowsEqual", r.accRowsEqual());
        add(object, "gyrRowsEqual", r.gyrRowsEqual());
        add(object, "frpRowsEqual", r.frpRowsEqual());
        add(object, "restMetres", r.restMetres());
        add(object, "restDegrees", r.restDegrees());
        add(object, "firstDivergenceSeconds", r.firstDivergenceSeconds());
        return object;
    }

    private static void add(JsonObject object, String name, OptionalDouble value) {
        boolean writable = value.isPresent() && Double.isFinite(value.getAsDouble());
        object.add(name, writable ? new JsonPrimitive(value.getAsDouble()) : JsonNull.INSTANCE);
    }
}
