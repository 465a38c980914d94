package org.robonewbie.workshop.speed;

import com.google.gson.GsonBuilder;
import com.google.gson.JsonNull;
import com.google.gson.JsonPrimitive;
import com.google.gson.JsonSerializer;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.OptionalDouble;

/**
 * Results of a benchmark.
 *
 * @param runs one run per number of robots and scene, in the order of measurement
 */
public record BenchmarkReport(List<BenchmarkRun> runs) {

    private static final String HEADER = String.format(
            Locale.ROOT,
            "%6s %-9s %7s %12s %16s %15s %12s%n",
            "robots",
            "scene",
            "threads",
            "x real time",
            "CPU ms per cycle",
            "bytes per cycle",
            "peak memory");

    /**
     * Processor time of rcssserver3d 0.7.3 per cycle in milliseconds, by the number of moving robots, measured on comparable
     * hardware.
     */
    private static final Map<Integer, Double> MILLIS_OF_THE_ORIGINAL =
            Map.of(1, 0.45, 2, 0.9, 6, 2.75, 11, 5.5, 22, 14.4);

    /** Stores an unmodifiable copy of the list. */
    public BenchmarkReport {
        runs = List.copyOf(runs);
    }

    /** {@return the names of the columns of {@link #line}} */
    public static String header() {
        return HEADER;
    }

    /**
     * Formats a run as a line of the console table.
     *
     * @param run the run
     * @return one line with its line break
     */
    public static String line(BenchmarkRun run) {
        return String.format(
                Locale.ROOT,
                "%6d %-9s %7s %12.1f %16s %15s %9.0f MB%n",
                run.robots(),
                run.scene(),
                run.threads() == 0 ? "-" : String.valueOf(run.threads()),
                run.realTimeFactor(),
                text("%.3f", run.cpuMillisPerCycle()),
                text("%.0f", run.allocatedBytesPerCycle()),
                run.peakMemoryBytes() / 1e6);
    }

    private static String text(String format, OptionalDouble value) {
        return value.isPresent() ? String.format(Locale.ROOT, format, value.getAsDouble()) : "-";
    }

    /**
     * Formats the results as JSON: {@code {"runs":[{"robots":…,"scene":…,"threads":…,"realTimeFactor":…,
     * "cpuMillisPerCycle":…,"allocatedBytesPerCycle":…,"cycles":…,"peakMemoryBytes":…,"heap":[{"seconds":…,"bytes":…}]}]}}.
     * Unknown values are null.
     *
     * @return JSON text
     */
    public String toJson() {
        JsonSerializer<OptionalDouble> nullIfUnknown = (value, type, context) ->
                value.isPresent() ? new JsonPrimitive(value.getAsDouble()) : JsonNull.INSTANCE;
        JsonSerializer<CrowdScene> name = (scene, type, context) -> new JsonPrimitive(scene.toString());
        return new GsonBuilder()
                        .registerTypeAdapter(OptionalDouble.class, nullIfUnknown)
                        .registerTypeHierarchyAdapter(CrowdScene.class, name)
                        .serializeNulls()
                        .setPrettyPrinting()
                        .create()
                        .toJson(this)
                + "\n";
    }

    /**
     * Formats the results as a Markdown table with a row per number of robots, a column per scene, and the values of
     * rcssserver3d for comparison.
     *
     * @return Markdown text
     */
    public String toMarkdown() {
        List<CrowdScene> scenes =
                runs.stream().map(BenchmarkRun::scene).distinct().toList();
        StringBuilder table = new StringBuilder("| robots |");
        scenes.forEach(scene -> table.append(' ').append(scene).append(" |"));
        table.append(" rcssserver3d 0.7.3, robots moving |\n|")
                .append("---|".repeat(scenes.size() + 2))
                .append('\n');
        runs.stream().map(BenchmarkRun::robots).distinct().forEach(robots -> {
            table.append("| ").append(robots).append(" |");
            scenes.forEach(
                    scene -> table.append(' ').append(cell(robots, scene)).append(" |"));
            table.append(' ').append(original(robots)).append(" |\n");
        });
        return table.toString();
    }

    private String cell(int robots, CrowdScene scene) {
        return runs.stream()
                .filter(run -> run.robots() == robots && run.scene() == scene)
                .findFirst()
                .map(run -> String.format(
                        Locale.ROOT, "%s ms, %.0f ×", text("%.2f", run.cpuMillisPerCycle()), run.realTimeFactor()))
                .orElse("-");
    }

    private static String original(int robots) {
        Double millis = MILLIS_OF_THE_ORIGINAL.get(robots);
        return millis == null ? "-" : millis + " ms";
    }
}
