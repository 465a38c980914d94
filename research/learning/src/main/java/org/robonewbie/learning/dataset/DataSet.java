package org.robonewbie.learning.dataset;

import com.google.gson.Gson;
import com.google.gson.GsonBuilder;
import com.google.gson.JsonElement;
import com.google.gson.JsonObject;
import com.google.gson.JsonParser;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeMap;
import org.jspecify.annotations.Nullable;
import org.robonewbie.nao.file.AtomicFile;
import org.robonewbie.trial.batch.Journal;

/**
 * Folder with the tables of many runs: {@code cycles/run-00001.csv}, {@code events/run-00001.csv} and so on, the table of
 * runs {@code runs.csv}, and a description of the tables, {@code dataset.json}. Files are written atomically.
 *
 * <pre>{@code
 * DataSet set = DataSet.create(folder, false, facts);
 * try (RunTables tables = set.begin(1, seed)) {
 *     simulator.control().addObserver(tables); // Run the simulation to its end, then:
 *     set.add(tables.finish());
 * }
 * set.finish(1);
 * }</pre>
 */
public final class DataSet {

    private static final String CYCLES = "cycles";
    private static final String EVENTS = "events";
    private static final String DESCRIPTION = "dataset.json";

    /** Journal with a line for each complete run; it is replaced by the table of runs at the end. */
    private static final String JOURNAL = "runs.txt";

    private static final Gson GSON = new GsonBuilder().setPrettyPrinting().create();

    private final Path folder;
    private final CycleTable table;
    private final Map<String, String> facts;
    private final RunFiles cycles;
    private final RunFiles events;
    private final Map<Integer, RunResult> runs = new TreeMap<>();
    private @Nullable Journal journal;

    private DataSet(Path folder, boolean withMessages, Map<String, String> facts) {
        this.folder = folder;
        this.table = new CycleTable(withMessages);
        this.facts = new LinkedHashMap<>(facts);
        this.cycles = new RunFiles(folder.resolve(CYCLES));
        this.events = new RunFiles(folder.resolve(EVENTS));
    }

    /** {@return the columns of the table of cycles, including those of the messages} */
    public static List<Column> columns() {
        return new CycleTable(true).columns();
    }

    /**
     * Creates a data set, or resumes an interrupted one and keeps its complete runs.
     *
     * @param folder the folder, which is created if it is missing
     * @param withMessages whether to record the messages between robots and agents as text
     * @param facts additional properties for the description, such as versions and settings
     * @return the data set
     * @throws IOException if the folder cannot be written to
     * @throws IllegalArgumentException if the folder contains a complete data set, or an incomplete one with different
     *     settings
     */
    public static DataSet create(Path folder, boolean withMessages, Map<String, String> facts) throws IOException {
        DataSet set = new DataSet(folder, withMessages, facts);
        if (Files.exists(folder.resolve(DESCRIPTION))) {
            set.requireSameDescription();
        } else {
            Files.createDirectories(folder.resolve(CYCLES));
            Files.createDirectories(folder.resolve(EVENTS));
            set.describe(false);
        }
        set.resume();
        return set;
    }

    private void requireSameDescription() throws IOException {
        JsonObject found = JsonParser.parseString(Files.readString(folder.resolve(DESCRIPTION)))
                .getAsJsonObject();
        if (found.get("complete").getAsBoolean()) {
            throw new IllegalArgumentException(
                    folder + " already contains a complete data set. Name another folder, or delete it first.");
        }
        JsonObject wanted = description(false);
        removeVariableParts(wanted);
        removeVariableParts(found);
        if (!found.equals(wanted)) {
            throw new IllegalArgumentException(folder + " contains an incomplete data set with other settings: "
                    + difference(found, wanted) + ". Name another folder, or delete it first.");
        }
    }

    /** Removes the properties in which the descriptions of an interrupted and a resumed data set may differ. */
    private static void removeVariableParts(JsonObject description) {
        description.remove("runs");
        for (JsonElement table : description.getAsJsonObject("tables").asMap().values()) {
            for (JsonElement column : table.getAsJsonObject().getAsJsonArray("columns")) {
                column.getAsJsonObject().remove("meaning");
            }
        }
    }

    private static String difference(JsonObject found, JsonObject wanted) {
        return wanted.keySet().stream()
                .filter(name -> !wanted.get(name).equals(found.get(name)))
                .findFirst()
                .map(name -> wanted.get(name).isJsonPrimitive()
                        ? name + " is " + found.get(name) + " there and " + wanted.get(name) + " now"
                        : "its " + name + " differ")
                .orElse("it has more properties");
    }

    /** Loads each run whose journal line and tables are complete. */
    private void resume() throws IOException {
        Journal opened = Journal.open(folder.resolve(JOURNAL), "");
        journal = opened;
        Set<Integer> complete = cycles.present();
        complete.retainAll(events.present());
        opened.lines().stream()
                .map(RunResult::read)
                .flatMap(Optional::stream)
                .filter(found -> complete.contains(found.run()))
                .forEach(found -> runs.put(found.run(), found));
    }

    /**
     * Returns whether a run is complete.
     *
     * @param run the number of the run, starting from 1
     * @return whether its tables are complete
     */
    public synchronized boolean has(int run) {
        RunResult found = runs.get(run);
        return found != null && found.hasTables();
    }

    /**
     * Begins the tables of a run.
     *
     * @param run the number of the run, starting from 1
     * @param seed the seed of the run
     * @return the tables, which must be added to the simulation as an observer
     * @throws IOException if a file cannot be written
     */
    public RunTables begin(int run, long seed) throws IOException {
        TableFile ofCycles = new TableFile(cycles.of(run), table.columns());
        TableFile ofEvents = new TableFile(events.of(run), RunTables.eventColumns());
        return new RunTables(run, seed, table, ofCycles, ofEvents);
    }

    /**
     * Adds a run that has ended, with or without tables.
     *
     * @param result the result of the run
     * @throws IOException if a file cannot be written
     */
    public synchronized void add(RunResult result) throws IOException {
        if (!result.hasTables()) {
            discard(result.run());
        } else if (journal != null) {
            journal.add(result.line());
        }
        runs.put(result.run(), result);
    }

    /**
     * Deletes the unfinished tables of a run.
     *
     * @param run the number of the run, starting from 1
     * @throws IOException if a file cannot be deleted
     */
    public void discard(int run) throws IOException {
        cycles.discard(run);
        events.discard(run);
    }

    /** {@return the runs in which the agent failed, ordered by number} */
    public synchronized List<RunResult> failures() {
        return runs.values().stream()
                .filter(result -> !result.failure().isEmpty())
                .toList();
    }

    /** {@return the number of runs whose tables are complete} */
    public synchronized int runs() {
        return (int) runs.values().stream().filter(RunResult::hasTables).count();
    }

    /**
     * Completes the data set with the table of runs.
     *
     * @param runsPerFile the number of consecutive runs whose tables are joined into one file, at least 1
     * @throws IOException if a file cannot be written
     */
    public synchronized void finish(int runsPerFile) throws IOException {
        int last = runs.keySet().stream().mapToInt(run -> run).max().orElse(0);
        for (int first = 1; first <= last; first += runsPerFile) {
            int end = Math.min(last, first + runsPerFile - 1);
            if (end > first) {
                cycles.join(first, end, table.columns());
                events.join(first, end, RunTables.eventColumns());
            }
        }
        writeRuns();
        describe(true);
        if (journal != null) {
            journal.delete();
        }
    }

    /**
     * Closes the data set before all runs are complete. Its description marks it as incomplete.
     *
     * @throws IOException if a file cannot be written
     */
    public synchronized void endEarly() throws IOException {
        writeRuns();
        describe(false);
    }

    private void writeRuns() throws IOException {
        try (TableFile file = new TableFile(folder.resolve("runs" + TableFile.EXTENSION), RunResult.columns())) {
            for (RunResult run : runs.values()) {
                file.add(run.row());
            }
            file.finish();
        }
    }

    private void describe(boolean complete) throws IOException {
        AtomicFile.write(folder.resolve(DESCRIPTION), GSON.toJson(description(complete)) + "\n");
    }

    private JsonObject description(boolean complete) {
        JsonObject all = new JsonObject();
        all.addProperty("format", "RoboNewbie data set, version 1");
        all.addProperty("complete", complete);
        facts.forEach(all::addProperty);
        all.addProperty("runs", runs());
        JsonObject tables = new JsonObject();
        tables.add(CYCLES, described("cycles/run-*" + TableFile.EXTENSION, table.columns()));
        tables.add(EVENTS, described("events/run-*" + TableFile.EXTENSION, RunTables.eventColumns()));
        tables.add("runs", described("runs" + TableFile.EXTENSION, RunResult.columns()));
        all.add("tables", tables);
        return all;
    }

    private static JsonObject described(String files, List<Column> columns) {
        JsonObject result = new JsonObject();
        result.addProperty("files", files);
        result.add("columns", GSON.toJsonTree(columns));
        return result;
    }
}
