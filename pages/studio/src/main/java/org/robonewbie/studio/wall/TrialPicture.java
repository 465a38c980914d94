package org.robonewbie.studio.wall;

import com.google.gson.JsonArray;
import com.google.gson.JsonObject;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.concurrent.TimeUnit;
import org.jspecify.annotations.Nullable;
import org.robonewbie.nao.Vector3;
import org.robonewbie.nao.kinematics.BodyState;
import org.robonewbie.simulator.RobotSnapshot;
import org.robonewbie.simulator.SimulationControl;
import org.robonewbie.simulator.SimulationObserver;
import org.robonewbie.simulator.WorldSnapshot;

/** Top view of a running trial for a {@link TrialWall}, updated several times per second. */
final class TrialPicture implements SimulationObserver {

    private static final long INTERVAL_NANOS = TimeUnit.MILLISECONDS.toNanos(TrialWall.PICTURE_MILLIS / 2);
    private static final double ROUNDING = 100;

    private final String id;
    private final SimulationControl simulation;
    private final JsonObject facts = new JsonObject();
    private volatile @Nullable WorldSnapshot latest;
    private long takenNanos = System.nanoTime() - INTERVAL_NANOS;

    /**
     * Starts observing a trial.
     *
     * @param id name of the trial
     * @param teams names of the teams
     * @param simulation the trial
     * @param studio address of the page that shows only this trial
     */
    TrialPicture(String id, List<String> teams, SimulationControl simulation, String studio) {
        this.id = id;
        this.simulation = simulation;
        JsonArray names = new JsonArray();
        teams.forEach(names::add);
        facts.addProperty("id", id);
        facts.add("teams", names);
        facts.addProperty("studio", studio);
        facts.addProperty("length", simulation.field().length());
        facts.addProperty("width", simulation.field().width());
        simulation.addObserver(this);
    }

    void leave() {
        simulation.removeObserver(this);
    }

    @Override
    public boolean wantsSnapshot() {
        return System.nanoTime() - takenNanos >= INTERVAL_NANOS;
    }

    @Override
    public void cycleEnded(WorldSnapshot snapshot) {
        takenNanos = System.nanoTime();
        latest = snapshot;
    }

    /** Returns the data that do not change while the trial runs. */
    JsonObject facts() {
        return facts;
    }

    /** Returns the current positions; empty before the first cycle. */
    Optional<JsonObject> moment() {
        return Optional.ofNullable(latest).map(this::written);
    }

    private JsonObject written(WorldSnapshot snapshot) {
        JsonObject json = new JsonObject();
        json.addProperty("id", id);
        json.addProperty("seconds", rounded(snapshot.gameTime()));
        json.addProperty("playMode", snapshot.playMode().simSparkName());
        json.addProperty("left", snapshot.teamLeft());
        json.addProperty("right", snapshot.teamRight());
        JsonArray score = new JsonArray();
        score.add(snapshot.scoreLeft());
        score.add(snapshot.scoreRight());
        json.add("score", score);
        json.add("ball", place(snapshot.ballPosition()));
        JsonArray robots = new JsonArray();
        snapshot.robots().forEach(robot -> robots.add(robot(robot)));
        json.add("robots", robots);
        return json;
    }

    private static JsonObject robot(RobotSnapshot robot) {
        BodyState body = robot.body();
        JsonObject json = new JsonObject();
        json.addProperty(
                "side",
                robot.side().map(side -> side.name().toLowerCase(Locale.ROOT)).orElse(""));
        json.addProperty("number", robot.number());
        json.add("place", place(body.position()));
        json.addProperty("heading", Math.round(body.headingDegrees()));
        json.addProperty("fallen", body.isFallen());
        return json;
    }

    private static JsonArray place(Vector3 position) {
        JsonArray json = new JsonArray();
        json.add(rounded(position.x()));
        json.add(rounded(position.y()));
        return json;
    }

    private static double rounded(double value) {
        return Math.round(ROUNDING * value) / ROUNDING;
    }
}
