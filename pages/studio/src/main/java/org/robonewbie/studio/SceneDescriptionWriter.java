package org.robonewbie.studio;

import com.google.gson.JsonArray;
import com.google.gson.JsonObject;
import java.util.Arrays;
import java.util.Locale;
import org.robonewbie.nao.PlayMode;
import org.robonewbie.nao.SoccerField;
import org.robonewbie.nao.Vector3;
import org.robonewbie.nao.model.Hinge;
import org.robonewbie.nao.model.Link;
import org.robonewbie.nao.model.NaoModel;
import org.robonewbie.nao.model.RobotType;
import org.robonewbie.protocol.telemetry.TelemetryItem;
import org.robonewbie.simulator.TrialLabel;
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
        JsonObject json = new JsonObject();
        json.addProperty("kind", "scene");
        json.addProperty("revision", revision);
        json.add("field", field(scene.field()));
        json.addProperty("clock", scene.clock());
        scene.agentPort().ifPresent(port -> json.addProperty("agentPort", port));
        json.addProperty("puppets", scene.puppets());
        scene.trial().ifPresent(trial -> json.add("trial", trial(trial)));
        JsonObject teams = new JsonObject();
        teams.addProperty("left", scene.teamLeft());
        teams.addProperty("right", scene.teamRight());
        json.add("teams", teams);
        JsonArray robots = new JsonArray();
        JsonObject models = new JsonObject();
        for (SceneDescription.Player player : scene.robots()) {
            robots.add(player(player));
            if (!models.has(player.type().name())) {
                models.add(player.type().name(), model(NaoModel.of(player.type())));
            }
        }
        json.add("robots", robots);
        JsonArray things = new JsonArray();
        scene.things().forEach(thing -> things.add(thing(thing)));
        json.add("things", things);
        json.add("models", models);
        JsonArray playModes = new JsonArray();
        Arrays.stream(PlayMode.values()).map(PlayMode::simSparkName).forEach(playModes::add);
        json.add("playModes", playModes);
        return json.toString();
    }

    private static JsonObject field(SoccerField field) {
        JsonObject json = new JsonObject();
        json.addProperty("length", field.length());
        json.addProperty("width", field.width());
        json.addProperty("goalWidth", field.goalWidth());
        json.addProperty("goalDepth", field.goalDepth());
        json.addProperty("goalHeight", field.goalHeight());
        json.addProperty("penaltyLength", field.penaltyLength());
        json.addProperty("penaltyWidth", field.penaltyWidth());
        json.addProperty("centreCircleRadius", field.centreCircleRadius());
        return json;
    }

    private static JsonObject trial(TrialLabel trial) {
        JsonObject json = new JsonObject();
        json.addProperty("task", trial.task());
        json.addProperty("attempt", trial.attempt());
        json.addProperty("seed", trial.seed());
        return json;
    }

    private static JsonObject player(SceneDescription.Player player) {
        JsonObject json = new JsonObject();
        json.addProperty("id", player.id());
        json.addProperty("team", player.team());
        json.addProperty(
                "side",
                player.side().map(side -> side.name().toLowerCase(Locale.ROOT)).orElse(""));
        json.addProperty("number", player.number());
        json.addProperty("type", player.type().name());
        json.addProperty("puppet", player.puppet());
        return json;
    }

    private static JsonObject thing(SceneDescription.Standing thing) {
        JsonObject json = new JsonObject();
        json.addProperty("name", thing.name());
        json.add("size", vector(thing.size()));
        json.addProperty("movable", thing.movable());
        return json;
    }

    static String event(MatchEvent event) {
        JsonObject json = new JsonObject();
        json.addProperty("kind", "event");
        json.addProperty("text", event.text());
        return json.toString();
    }

    /** Writes a warning or error from a robot's program. */
    static String diagnostic(String team, int number, TelemetryItem.LogEntry line) {
        JsonObject json = new JsonObject();
        json.addProperty("kind", "mistake");
        json.addProperty("team", team);
        json.addProperty("number", number);
        json.addProperty("level", line.level());
        json.addProperty("text", line.text());
        return json.toString();
    }

    /** Writes the names of the commands that would be undone and redone next. */
    static String undoManager(UndoManager.Names names) {
        JsonObject json = new JsonObject();
        json.addProperty("kind", "undo");
        json.addProperty("undo", names.undo());
        json.addProperty("redo", names.redo());
        return json.toString();
    }

    /** Writes a message from the simulator to the user. */
    static String notice(String sentence) {
        JsonObject json = new JsonObject();
        json.addProperty("kind", "told");
        json.addProperty("text", sentence);
        return json.toString();
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
        JsonArray links = new JsonArray();
        model.links().forEach(link -> links.add(link(link)));
        JsonArray hinges = new JsonArray();
        model.hinges().forEach(hinge -> hinges.add(hinge(hinge, model)));
        JsonObject json = new JsonObject();
        json.add("links", links);
        json.add("hinges", hinges);
        return json;
    }

    private static JsonObject link(Link link) {
        JsonObject json = new JsonObject();
        json.addProperty("name", link.name());
        json.add("position", vector(link.position()));
        json.add("size", vector(link.shape().size()));
        return json;
    }

    private static JsonObject hinge(Hinge hinge, NaoModel model) {
        JsonObject json = new JsonObject();
        json.addProperty("joint", hinge.jointName());
        json.addProperty("child", model.linkIndex(hinge.child()));
        json.addProperty("parent", model.linkIndex(hinge.parent()));
        json.add("anchor", vector(hinge.anchor()));
        json.add("axis", vector(hinge.axis()));
        json.addProperty("minDegrees", hinge.minDegrees());
        json.addProperty("maxDegrees", hinge.maxDegrees());
        json.addProperty("effector", hinge.effectorName());
        json.addProperty("maxSpeed", Math.toDegrees(hinge.maxRadiansPerSecond()));
        return json;
    }

    private static JsonArray vector(Vector3 vector) {
        JsonArray json = new JsonArray();
        json.add(vector.x());
        json.add(vector.y());
        json.add(vector.z());
        return json;
    }
}
