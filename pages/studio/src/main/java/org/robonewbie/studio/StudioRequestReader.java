package org.robonewbie.studio;

import com.google.gson.JsonElement;
import com.google.gson.JsonObject;
import com.google.gson.JsonParseException;
import com.google.gson.JsonParser;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import org.robonewbie.nao.Joint;
import org.robonewbie.nao.PlayMode;
import org.robonewbie.nao.SoccerField;
import org.robonewbie.nao.TeamSide;
import org.robonewbie.nao.Vector3;
import org.robonewbie.protocol.order.Order;
import org.robonewbie.protocol.order.PlayerNumber;
import org.robonewbie.protocol.telemetry.TuningRequest;
import org.robonewbie.simulator.SimulationControl;

/**
 * Parser and validator of page commands such as <code>{"do":"step","cycles":1}</code>. Out-of-range values never reach
 * the simulation.
 */
final class StudioRequestReader {

    private static final double MIN_SPEED = 0.1;
    private static final double MAX_SPEED = 100;
    private static final int MAX_CYCLES = 50_000;
    private static final double REACH_METRES = 50;
    private static final double MAX_METRES_PER_SECOND = 20;
    private static final int PLAYERS = 11;
    private static final double MAX_GESTURE = 1e15;
    private static final Order BALL_TO_CENTRE =
            new Order.MoveBall(new Vector3(0, 0, SoccerField.BALL_RADIUS), Vector3.ZERO);

    private final JsonObject json;

    private StudioRequestReader(JsonObject json) {
        this.json = json;
    }

    /**
     * Parses a command.
     *
     * @param text one JSON object
     * @return the command
     * @throws IllegalArgumentException if the command is invalid; the message is shown on the page
     */
    static StudioRequest read(String text) {
        try {
            return new StudioRequestReader(JsonParser.parseString(text).getAsJsonObject()).read();
        } catch (JsonParseException | IllegalStateException e) {
            throw new IllegalArgumentException("The studio cannot read \"" + text + "\". Reload the page.", e);
        }
    }

    private StudioRequest read() {
        String name = text("do");
        return switch (name) {
            case "seen" -> new StudioRequest.Seen();
            case "watch" -> new StudioRequest.Watch(text("team"), (int) number("number", 0, PLAYERS));
            case "tune" ->
                new StudioRequest.Tune(new TuningRequest(
                        text("team"),
                        (int) number("number", 0, PLAYERS),
                        text("name"),
                        number("value", -Double.MAX_VALUE, Double.MAX_VALUE)));
            case "pause" -> order(new Order.Pause());
            case "resume" -> order(new Order.Resume());
            case "step" -> order(new Order.Step((int) number("cycles", 1, MAX_CYCLES)));
            case "speed" -> order(new Order.SetSpeed(speed()));
            case "undo" -> StudioRequest.History.UNDO;
            case "redo" -> StudioRequest.History.REDO;
            case "reset" -> new StudioRequest.Change("reset", new Order.Reset());
            case "placeBall" -> dragged("ball moved", new Order.MoveBall(position(), Vector3.ZERO));
            case "throwBall" -> dragged("ball thrown", new Order.MoveBall(Optional.empty(), Optional.of(velocity())));
            case "placeRobot" -> placedRobot();
            case "kickOff" -> new StudioRequest.Change("kick-off", new Order.KickOff(side()), BALL_TO_CENTRE);
            case "dropBall" -> new StudioRequest.Change("ball dropped", new Order.DropBall());
            case "playMode" -> new StudioRequest.Change("play mode changed", new Order.ChangePlayMode(playMode()));
            case "addPuppet" -> new StudioRequest.AddPuppet(side());
            case "removePuppet" -> new StudioRequest.RemovePuppet(player());
            case "walk" -> {
                double forward = part("forward");
                double left = part("left");
                double turn = part("turn");
                yield new PuppetOrder(player(), puppet -> puppet.walk(forward, left, turn));
            }
            case "perform" -> new PuppetOrder(player(), puppet -> puppet.perform(text("motion")));
            case "look" -> {
                double yaw = number("yaw", -180, 180);
                double pitch = number("pitch", -180, 180);
                yield new PuppetOrder(player(), puppet -> puppet.look(yaw, pitch));
            }
            case "hold" -> {
                Joint joint = joint();
                double degrees = number("degrees", -180, 180);
                yield new PuppetOrder(player(), puppet -> puppet.hold(joint, degrees));
            }
            default -> throw new IllegalArgumentException("Unknown command \"" + name + "\". Reload the page.");
        };
    }

    private StudioRequest placedRobot() {
        Order order = new Order.PlaceRobot(player(), position(), number("headingDegrees", -360, 360));
        return dragged(text("turn").equals("true") ? "robot turned" : "robot moved", order);
    }

    /** All commands from one drag share a gesture number, which makes them one undoable change. */
    private StudioRequest dragged(String name, Order order) {
        long gesture = json.has("gesture") ? (long) number("gesture", 0, MAX_GESTURE) : 0;
        return new StudioRequest.Change(name, gesture, List.of(order));
    }

    private static StudioRequest order(Order order) {
        return new StudioRequest.Orders(order);
    }

    private double speed() {
        boolean fastest = json.has("factor") && text("factor").equals("fastest");
        return fastest ? SimulationControl.AS_FAST_AS_POSSIBLE : number("factor", MIN_SPEED, MAX_SPEED);
    }

    private PlayerNumber player() {
        return new PlayerNumber(side(), (int) number("number", 1, PLAYERS));
    }

    private double part(String key) {
        return number(key, -1, 1);
    }

    private Joint joint() {
        return Arrays.stream(Joint.values())
                .filter(joint -> joint.name().equals(text("joint")))
                .findFirst()
                .orElseThrow(() -> new IllegalArgumentException(
                        "The robot has no joint \"" + text("joint") + "\". Reload the page."));
    }

    private Vector3 position() {
        return new Vector3(
                number("x", -REACH_METRES, REACH_METRES),
                number("y", -REACH_METRES, REACH_METRES),
                number("z", 0, REACH_METRES));
    }

    private Vector3 velocity() {
        return new Vector3(
                number("x", -MAX_METRES_PER_SECOND, MAX_METRES_PER_SECOND),
                number("y", -MAX_METRES_PER_SECOND, MAX_METRES_PER_SECOND),
                number("z", -MAX_METRES_PER_SECOND, MAX_METRES_PER_SECOND));
    }

    private TeamSide side() {
        return switch (text("side")) {
            case "left" -> TeamSide.LEFT;
            case "right" -> TeamSide.RIGHT;
            default ->
                throw new IllegalArgumentException(
                        "The side \"" + text("side") + "\" does not exist. Choose \"left\" or \"right\".");
        };
    }

    private PlayMode playMode() {
        return PlayMode.ofSimSparkName(text("mode"))
                .orElseThrow(() -> new IllegalArgumentException(
                        "The play mode \"" + text("mode") + "\" does not exist. Choose one from the list."));
    }

    private double number(String key, double min, double max) {
        double value = numberOrNaN(key);
        if (!(value >= min && value <= max)) {
            throw new IllegalArgumentException(String.format(
                    Locale.ROOT,
                    "The value %s for \"%s\" of \"%s\" is out of range. Choose a value from %s to %s.",
                    json.get(key),
                    key,
                    text("do"),
                    min,
                    max));
        }
        return value;
    }

    private double numberOrNaN(String key) {
        try {
            return json.has(key) ? json.get(key).getAsDouble() : Double.NaN;
        } catch (NumberFormatException | UnsupportedOperationException | IllegalStateException e) {
            return Double.NaN;
        }
    }

    private String text(String key) {
        JsonElement element = json.get(key);
        return element != null && element.isJsonPrimitive() ? element.getAsString() : "";
    }
}
