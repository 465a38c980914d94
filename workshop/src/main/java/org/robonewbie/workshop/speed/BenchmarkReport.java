package org.robonewbie.workshop.speed;

import com.google.gson.GsonBuilder;
import com.google.gson.JsonArray;
import com.google.gson.JsonObject;
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

    /** Copies the list. */
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
     * @return a line with its line break
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
        JsonArray list = new JsonArray();
        runs.forEach(run -> list.add(json(run)));
        JsonObject all = new JsonObject();
        all.add("runs", list);
        return new GsonBuilder().serializeNulls().setPrettyPrinting().create().toJson(all) + "\n";
    }

    /**
     * Formats the results as a Markdown table with a row per number of robots, a column per scene, and the figures of
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

    private static JsonObject json(BenchmarkRun run) {
        JsonObject object = new JsonObject();
        object.addProperty("robots", run.robots());
        object.addProperty("scene", run.scene().toString());
        object.addProperty("threads", run.threads());
        object.addProperty("realTimeFactor", run.realTimeFactor());
        add(object, "cpuMillisPerCycle", run.cpuMillisPerCycle());
        add(object, "allocatedBytesPerCycle", run.allocatedBytesPerCycle());
        object.addProperty("cycles", run.cycles());
        object.addProperty("peakMemoryBytes", run.peakMemoryBytes());
        JsonArray heap = new JsonArray();
        run.heap().forEach(sample -> heap.add(json(sample)));
        object.add("heap", heap);
        return object;
    }

    private static JsonObject json(HeapSample sample) {
        JsonObject object = new JsonObject();
        object.addProperty("seconds", sample.seconds());
        object.addProperty("bytes", sample.bytes());
        return object;
    }

    private static void add(JsonObject object, String name, OptionalDouble value) {
        object.addProperty(name, value.isPresent() ? value.getAsDouble() : null);
    }
}
