package org.robonewbie.studio.wall;

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
import org.robonewbie.simulator.json.Json;

/** Top view of a running trial for a {@link TrialWall}, updated several times per second. */
final class TrialPicture implements SimulationObserver {

    private static final long INTERVAL_NANOS = TimeUnit.MILLISECONDS.toNanos(TrialWall.PICTURE_MILLIS / 2);
    private static final double ROUNDING = 100;

    private final String id;
    private final SimulationControl simulation;
    private final JsonObject facts;
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
        facts = Json.object(
                "id", id,
                "teams", teams,
                "studio", studio,
                "length", simulation.field().length(),
                "width", simulation.field().width());
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

    /** Returns the data that does not change while the trial is running. */
    JsonObject facts() {
        return facts;
    }

    /** Returns the current positions; empty if no cycle has been simulated yet. */
    Optional<JsonObject> moment() {
        return Optional.ofNullable(latest).map(this::written);
    }

    private JsonObject written(WorldSnapshot snapshot) {
        return Json.object(
                "id", id,
                "seconds", rounded(snapshot.gameTime()),
                "playMode", snapshot.playMode().simSparkName(),
                "left", snapshot.teamLeft(),
                "right", snapshot.teamRight(),
                "score", List.of(snapshot.scoreLeft(), snapshot.scoreRight()),
                "ball", place(snapshot.ballPosition()),
                "robots", Json.array(snapshot.robots().stream().map(TrialPicture::robot)));
    }

    private static JsonObject robot(RobotSnapshot robot) {
        BodyState body = robot.body();
        String side =
                robot.side().map(each -> each.name().toLowerCase(Locale.ROOT)).orElse("");
        return Json.object(
                "side", side,
                "number", robot.number(),
                "place", place(body.position()),
                "heading", Math.round(body.headingDegrees()),
                "fallen", body.isFallen());
    }

    private static List<Double> place(Vector3 position) {
        return List.of(rounded(position.x()), rounded(position.y()));
    }

    private static double rounded(double value) {
        return Math.round(ROUNDING * value) / ROUNDING;
    }
}
