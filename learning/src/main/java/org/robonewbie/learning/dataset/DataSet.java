package org.robonewbie.learning.dataset;

import com.google.gson.GsonBuilder;
import com.google.gson.JsonArray;
import com.google.gson.JsonObject;
import com.google.gson.JsonParser;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.robonewbie.nao.file.AtomicFile;

/**
 * A folder of tables about many runs: {@code cycles/run-00001.parquet} and so on, {@code events/run-00001.parquet} and so on,
 * {@code runs.parquet}, and {@code dataset.json}, which explains them all. Each file is there completely or not at all.
 *
 * <pre>{@code
 * DataSet set = DataSet.create(folder, TableFormat.PARQUET, false, facts);
 * try (RunTables tables = set.begin(1, seed)) {
 *     simulator.control().addObserver(tables); // then let the simulation run to its end
 *     set.add(tables);
 * }
 * set.finish();
 * }</pre>
 */
public final class DataSet {

    private static final String DESCRIPTION = "dataset.json";

    /** A line for each complete run, until the table of runs is written. */
    private static final String JOURNAL = "runs.txt";

    private static final String END = "complete";

    private final Path folder;
    private final TableFormat format;
    private final CycleTable table;
    private final Map<String, String> facts;
    private final List<List<Object>> runs = new ArrayList<>();

    private DataSet(Path folder, TableFormat format, boolean withMessages, Map<String, String> facts) {
        this.folder = folder;
        this.format = format;
        this.table = new CycleTable(withMessages);
        this.facts = new LinkedHashMap<>(facts);
    }

    /**
     * Creates a data set in a folder that has none yet, or goes on with one that was broken off: its complete runs are kept.
     *
     * @param folder the folder; it is created if it is missing
     * @param format how its tables are written
     * @param withMessages whether the messages of robots and programs are kept as text too
     * @param facts what it records about how it was made, such as versions and settings
     * @return the data set
     * @throws IOException if the folder cannot be written
     * @throws IllegalArgumentException if there is a complete data set already, or one that was made in another way
     */
    public static DataSet create(Path folder, TableFormat format, boolean withMessages, Map<String, String> facts)
            throws IOException {
        DataSet set = new DataSet(folder, format, withMessages, facts);
        if (Files.exists(folder.resolve(DESCRIPTION))) {
            set.goOn();
            return set;
        }
        Files.createDirectories(folder.resolve("cycles"));
        Files.createDirectories(folder.resolve("events"));
        set.describe(false);
        return set;
    }

    private void goOn() throws IOException {
        JsonObject found = JsonParser.parseString(Files.readString(folder.resolve(DESCRIPTION)))
                .getAsJsonObject();
        if (found.get("complete").getAsBoolean()) {
            throw new IllegalArgumentException(
                    folder + " holds a complete data set already. Name another folder, or delete it first.");
        }
        JsonObject wanted = description(false);
        wanted.remove("runs");
        found.remove("runs");
        if (!found.equals(wanted)) {
            throw new IllegalArgumentException(
                    folder + " holds a data set that is not complete and was made in another way: "
                            + difference(found, wanted) + ". Name another folder, or delete it first.");
        }
        if (Files.exists(folder.resolve(JOURNAL))) {
            for (String line : Files.readAllLines(folder.resolve(JOURNAL))) {
                keep(line);
            }
        }
    }

    private static String difference(JsonObject found, JsonObject wanted) {
        return wanted.keySet().stream()
                .filter(name -> !wanted.get(name).equals(found.get(name)))
                .findFirst()
                .map(name -> wanted.get(name).isJsonPrimitive()
                        ? name + " is " + found.get(name) + " there and " + wanted.get(name) + " now"
                        : "its " + name + " are others")
                .orElse("it tells more");
    }

    /** Takes a run over whose line and tables are complete. */
    private void keep(String line) {
        String[] words = line.split(" ", -1);
        if (words.length != RunTables.runColumns().size() + 1 || !words[words.length - 1].equals(END)) {
            return;
        }
        List<Object> summary = Arrays.stream(words)
                .limit(words.length - 1L)
                .<Object>map(Long::valueOf)
                .toList();
        int run = ((Long) summary.get(0)).intValue();
        boolean complete = Stream.of("cycles", "events")
                .allMatch(part -> Files.exists(folder.resolve(part).resolve(name(run) + "." + format)));
        if (complete && !has(run)) {
            runs.add(summary);
        }
    }

    /**
     * Looks whether a run is in the data set.
     *
     * @param run its number, from 1
     * @return whether its tables are complete
     */
    public boolean has(int run) {
        return runs.stream().anyMatch(summary -> summary.get(0).equals((long) run));
    }

    private static String name(int run) {
        return String.format(Locale.ROOT, "run-%05d", run);
    }

    /**
     * Begins the tables of a run.
     *
     * @param run its number, from 1
     * @param seed what chooses all that is random in it
     * @return the tables, which watch the simulation
     * @throws IOException if a file cannot be written
     */
    public RunTables begin(int run, long seed) throws IOException {
        Map<String, String> known = new LinkedHashMap<>(facts);
        known.put("run", Integer.toString(run));
        known.put("seed", Long.toString(seed));
        String name = name(run);
        TableFile cycles = format.begin(folder.resolve("cycles").resolve(name), table.columns(), known);
        TableFile events = format.begin(folder.resolve("events").resolve(name), RunTables.eventColumns(), known);
        return new RunTables(run, seed, table, cycles, events);
    }

    /**
     * Takes in the tables of a run that has ended.
     *
     * @param tables the tables
     * @return how many rows its table of cycles has
     * @throws IOException if a file cannot be written
     */
    public long add(RunTables tables) throws IOException {
        tables.finish();
        runs.add(tables.summary());
        String line = tables.summary().stream().map(String::valueOf).collect(Collectors.joining(" "));
        Files.writeString(
                folder.resolve(JOURNAL), line + " " + END + "\n", StandardOpenOption.CREATE, StandardOpenOption.APPEND);
        return tables.rows();
    }

    /** {@return the number of runs that were added} */
    public int runs() {
        return runs.size();
    }

    /**
     * Completes the data set with the table of runs.
     *
     * @throws IOException if a file cannot be written
     */
    public void finish() throws IOException {
        runs.sort(Comparator.comparing(summary -> (Long) summary.get(0)));
        writeRuns();
        describe(true);
        Files.deleteIfExists(folder.resolve(JOURNAL));
    }

    /**
     * Leaves the data set with fewer runs than were wanted; its description says that it is not complete.
     *
     * @throws IOException if a file cannot be written
     */
    public void endEarly() throws IOException {
        writeRuns();
        describe(false);
    }

    private void writeRuns() throws IOException {
        try (TableFile file = format.begin(folder.resolve("runs"), RunTables.runColumns(), facts)) {
            for (List<Object> run : runs) {
                file.add(run);
            }
            file.finish();
        }
    }

    private void describe(boolean complete) throws IOException {
        AtomicFile.write(
                folder.resolve(DESCRIPTION),
                new GsonBuilder().setPrettyPrinting().create().toJson(description(complete)) + "\n");
    }

    private JsonObject description(boolean complete) {
        JsonObject all = new JsonObject();
        all.addProperty("format", "RoboNewbie data set, version 1");
        all.addProperty("complete", complete);
        facts.forEach(all::addProperty);
        all.addProperty("runs", runs.size());
        JsonObject tables = new JsonObject();
        tables.add("cycles", described("cycles/run-*." + format, table.columns()));
        tables.add("events", described("events/run-*." + format, RunTables.eventColumns()));
        tables.add("runs", described("runs." + format, RunTables.runColumns()));
        all.add("tables", tables);
        return all;
    }

    private static JsonObject described(String files, List<Column> columns) {
        JsonArray list = new JsonArray();
        for (Column column : columns) {
            JsonObject one = new JsonObject();
            one.addProperty("name", column.name());
            one.addProperty("kind", column.kind().name().toLowerCase(Locale.ROOT));
            one.addProperty("unit", column.unit());
            one.addProperty("meaning", column.meaning());
            list.add(one);
        }
        JsonObject result = new JsonObject();
        result.addProperty("files", files);
        result.add("columns", list);
        return result;
    }
}
