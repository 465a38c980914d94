package org.robonewbie.learning.dataset;

import com.google.gson.GsonBuilder;
import com.google.gson.JsonArray;
import com.google.gson.JsonObject;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
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
     * Creates a data set in a folder that has none yet.
     *
     * @param folder the folder; it is created if it is missing
     * @param format how its tables are written
     * @param withMessages whether the messages of robots and programs are kept as text too
     * @param facts what it records about how it was made, such as versions and settings
     * @return the empty data set
     * @throws IOException if the folder cannot be written
     * @throws IllegalArgumentException if there is a data set already
     */
    public static DataSet create(Path folder, TableFormat format, boolean withMessages, Map<String, String> facts)
            throws IOException {
        if (Files.exists(folder.resolve(DESCRIPTION))) {
            throw new IllegalArgumentException(
                    folder + " holds a data set already. Name another folder, or delete it first.");
        }
        Files.createDirectories(folder.resolve("cycles"));
        Files.createDirectories(folder.resolve("events"));
        DataSet set = new DataSet(folder, format, withMessages, facts);
        set.describe(false);
        return set;
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
        String name = String.format(Locale.ROOT, "run-%05d", run);
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
        writeRuns();
        describe(true);
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
        AtomicFile.write(
                folder.resolve(DESCRIPTION),
                new GsonBuilder().setPrettyPrinting().create().toJson(all) + "\n");
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
