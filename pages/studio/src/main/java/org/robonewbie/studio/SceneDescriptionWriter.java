package org.robonewbie.studio;

import com.google.gson.JsonObject;
import java.util.List;
import java.util.Locale;
import org.robonewbie.nao.PlayMode;
import org.robonewbie.nao.SoccerField;
import org.robonewbie.nao.Vector3;
import org.robonewbie.nao.model.Hinge;
import org.robonewbie.nao.model.Link;
import org.robonewbie.nao.model.NaoModel;
import org.robonewbie.nao.model.RobotType;
import org.robonewbie.protocol.telemetry.TelemetryItem;
import org.robonewbie.simulator.PitchDetails;
import org.robonewbie.simulator.TrialLabel;
import org.robonewbie.simulator.json.Json;
import org.robonewbie.simulator.json.RobotModelJson;
import org.robonewbie.simulator.soccer.MatchEvent;

/** Writes a {@link SceneDescription} as JSON, including the bodies of all its robot types. */
final class SceneDescriptionWriter {

    private SceneDescriptionWriter() {}

    /**
     * Writes a scene.
     *
     * @param scene the scene
     * @param revision revision number of the scene, repeated in the state frames that belong to it
     * @return one JSON object
     */
    static String write(SceneDescription scene, int revision) {
        JsonObject json = Json.object(
                "kind", "scene", "revision", revision, "field", field(scene.field()), "clock", scene.clock());
        addDetails(scene, json);
        scene.agentPort().ifPresent(port -> json.addProperty("agentPort", port));
        json.addProperty("puppets", scene.puppets());
        scene.trial().ifPresent(trial -> json.add("trial", trial(trial)));
        json.add("teams", Json.object("left", scene.teamLeft(), "right", scene.teamRight()));
        JsonObject models = new JsonObject();
        for (RobotType type : RobotType.values()) {
            if (scene.robots().stream().anyMatch(robot -> robot.type().equals(type.name()))) {
                models.add(type.name(), model(NaoModel.of(type)));
            }
        }
        for (int i = 0; i < scene.models().size(); i++) {
            models.add(
                    SceneDescription.modelType(i),
                    RobotModelJson.write(scene.models().get(i)));
        }
        json.add("robots", Json.array(scene.robots().stream().map(SceneDescriptionWriter::player)));
        json.add("things", Json.array(scene.things().stream().map(SceneDescriptionWriter::thing)));
        json.add("models", models);
        List<PlayMode> playModes = scene.match() ? PlayMode.simSparkModes() : List.of(PlayMode.values());
        json.add("playModes", Json.array(playModes.stream().map(PlayMode::simSparkName)));
        return json.toString();
    }

    private static JsonObject field(SoccerField field) {
        return Json.object(
                "length", field.length(),
                "width", field.width(),
                "goalWidth", field.goalWidth(),
                "goalDepth", field.goalDepth(),
                "goalHeight", field.goalHeight(),
                "penaltyLength", field.penaltyLength(),
                "penaltyWidth", field.penaltyWidth(),
                "centreCircleRadius", field.centreCircleRadius());
    }

    /** Adds what differs from SimSpark's pitches and from a world that can be controlled. */
    private static void addDetails(SceneDescription scene, JsonObject json) {
        PitchDetails details = scene.details();
        if (!details.equals(PitchDetails.SIMSPARK)) {
            json.add(
                    "details",
                    Json.object(
                            "ballRadius", details.ballRadius(),
                            "goalAreaLength", details.goalAreaLength(),
                            "goalAreaWidth", details.goalAreaWidth(),
                            "penaltySpotDistance", details.penaltySpotDistance()));
        }
        if (!scene.match()) {
            json.addProperty("match", false);
        }
    }

    private static JsonObject trial(TrialLabel trial) {
        return Json.object("task", trial.task(), "attempt", trial.attempt(), "seed", trial.seed());
    }

    private static JsonObject player(SceneDescription.Player player) {
        return Json.object(
                "id", player.id(),
                "team", player.team(),
                "side",
                        player.side()
                                .map(side -> side.name().toLowerCase(Locale.ROOT))
                                .orElse(""),
                "number", player.number(),
                "type", player.type(),
                "puppet", player.puppet());
    }

    private static JsonObject thing(SceneDescription.Standing thing) {
        return Json.object("name", thing.name(), "size", vector(thing.size()), "movable", thing.movable());
    }

    static String event(MatchEvent event) {
        return Json.object("kind", "event", "text", event.text()).toString();
    }

    /** Writes a warning or error from a robot's program. */
    static String diagnostic(String team, int number, TelemetryItem.LogEntry line) {
        return Json.object(
                        "kind", "mistake", "team", team, "number", number, "level", line.level(), "text", line.text())
                .toString();
    }

    /** Writes the names of the commands that would be undone and redone next. */
    static String undoManager(UndoManager.Names names) {
        return Json.object("kind", "undo", "undo", names.undo(), "redo", names.redo())
                .toString();
    }

    /** Writes a notice from the simulator to the user. */
    static String notice(String sentence) {
        return Json.object("kind", "told", "text", sentence).toString();
    }

    /** Writes the bodies of all robot types by name. */
    static JsonObject allModels() {
        JsonObject models = new JsonObject();
        for (RobotType type : RobotType.values()) {
            models.add(type.name(), model(NaoModel.of(type)));
        }
        return models;
    }

    /** Writes the links and hinges of a robot's body. */
    static JsonObject model(NaoModel model) {
        return Json.object(
                "links", Json.array(model.links().stream().map(SceneDescriptionWriter::link)),
                "hinges", Json.array(model.hinges().stream().map(hinge -> hinge(hinge, model))));
    }

    private static JsonObject link(Link link) {
        return Json.object(
                "name", link.name(),
                "position", vector(link.position()),
                "size", vector(link.shape().size()));
    }

    private static JsonObject hinge(Hinge hinge, NaoModel model) {
        return Json.object(
                "joint", hinge.jointName(),
                "child", model.linkIndex(hinge.child()),
                "parent", model.linkIndex(hinge.parent()),
                "anchor", vector(hinge.anchor()),
                "axis", vector(hinge.axis()),
                "minDegrees", hinge.minDegrees(),
                "maxDegrees", hinge.maxDegrees(),
                "effector", hinge.effectorName(),
                "maxSpeed", Math.toDegrees(hinge.maxRadiansPerSecond()));
    }

    private static List<Double> vector(Vector3 vector) {
        return List.of(vector.x(), vector.y(), vector.z());
    }
}
