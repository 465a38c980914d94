package org.robonewbie.studio.wall;

import com.google.gson.Gson;
import com.google.gson.JsonArray;
import com.google.gson.JsonObject;
import java.net.URI;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;
import java.util.concurrent.ScheduledExecutorService;
import java.util.concurrent.TimeUnit;
import org.robonewbie.simulator.SimulationControl;
import org.robonewbie.simulator.json.Json;
import org.robonewbie.studio.board.EventBus;

/**
 * Overview page of a contest: one tile for each running trial, and the results table. Thread-safe.
 */
public final class TrialWall extends EventBus implements AutoCloseable {

    /** Interval between updates of the tiles, in milliseconds. */
    static final long PICTURE_MILLIS = 80;

    private final Gson gson = new Gson();
    private final JsonObject known = new JsonObject();
    private final JsonArray results = new JsonArray();
    private final Map<String, TrialPicture> running = new LinkedHashMap<>();
    private final ScheduledExecutorService painter =
            Executors.newSingleThreadScheduledExecutor(TrialWall::paintingThread);
    private final Future<?> painting;

    /**
     * Creates the overview page of a contest that has not started.
     *
     * @param title the contest's title
     * @param rule the rules, in one or two sentences
     */
    public TrialWall(String title, String rule) {
        super("wall", "wall.html");
        known.addProperty("kind", "whole");
        known.addProperty("title", title);
        known.addProperty("rule", rule);
        known.add("results", results);
        painting = painter.scheduleAtFixedRate(this::paint, PICTURE_MILLIS, PICTURE_MILLIS, TimeUnit.MILLISECONDS);
    }

    private static Thread paintingThread(Runnable work) {
        Thread thread = new Thread(work, "trial-wall");
        thread.setDaemon(true);
        return thread;
    }

    /**
     * Publishes the results table.
     *
     * @param table the current table
     */
    public synchronized void stands(WallTable table) {
        known.add("table", gson.toJsonTree(table));
        publishAll();
    }

    /**
     * Adds a tile for a trial that is starting.
     *
     * @param id name of the trial
     * @param teams names of the teams
     * @param simulation the trial
     * @param studio address of the page that shows only this trial
     */
    public synchronized void begins(String id, List<String> teams, SimulationControl simulation, URI studio) {
        running.put(id, new TrialPicture(id, teams, simulation, studio.toString()));
        publishAll();
    }

    /**
     * Stops updating the tile of a trial; its last picture remains until the tile is needed for another trial.
     *
     * @param id name of the trial
     */
    public synchronized void ends(String id) {
        Optional.ofNullable(running.remove(id)).ifPresent(TrialPicture::leave);
        publishAll();
    }

    /**
     * Publishes the result of a trial.
     *
     * @param id name of the trial
     * @param words the outcome
     */
    public synchronized void result(String id, String words) {
        results.add(Json.object("id", id, "words", words));
        publishAll();
    }

    /**
     * Publishes the end of the contest.
     *
     * @param words sentence with the location of the results
     */
    public synchronized void isOver(String words) {
        known.addProperty("outcome", words);
        publishAll();
    }

    @Override
    protected String known() {
        known.add("trials", Json.array(running.values().stream().map(TrialPicture::facts)));
        return known.toString();
    }

    private synchronized void paint() {
        if (isWatched() && !running.isEmpty()) {
            JsonArray moments = Json.array(
                    running.values().stream().map(TrialPicture::moment).flatMap(Optional::stream));
            publish(Json.object("kind", "moments", "moments", moments).toString());
        }
    }

    @Override
    public synchronized void close() {
        painting.cancel(false);
        painter.shutdownNow();
        running.values().forEach(TrialPicture::leave);
    }
}
