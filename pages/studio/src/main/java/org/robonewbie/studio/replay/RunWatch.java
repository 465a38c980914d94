package org.robonewbie.studio.replay;

import com.google.gson.JsonObject;
import com.google.gson.JsonParser;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import org.robonewbie.nao.kinematics.BodyState;
import org.robonewbie.simulator.json.Json;
import org.robonewbie.simulator.recording.ListedRobot;
import org.robonewbie.simulator.recording.RecordingState;

/** Incremental reader of an uncompressed recording that builds its summary. */
public final class RunWatch implements RecordingState.Listener {

    private static final List<String> KINDS = List.of("goal", "foul", "playmode");
    private static final double COSINE_OF_FALL = Math.cos(Math.toRadians(BodyState.FALLEN_DEGREES));

    private final RecordingState state = new RecordingState(this);
    private final List<JsonObject> events = new ArrayList<>();
    private final Trail ball = new Trail();
    private final Map<Integer, Trail> ways = new LinkedHashMap<>();
    private final Map<Integer, Integer> sides = new HashMap<>();
    private final Map<Integer, Boolean> upright = new HashMap<>();
    private final Map<List<ListedRobot>, int[]> rosters = new LinkedHashMap<>();
    private List<ListedRobot> present = List.of();
    private int[] cyclesOfRoster = rosters.computeIfAbsent(present, robotsThere -> new int[1]);
    private int robots;
    private int count;
    private long firstCycle;

    /** Creates a reader that has not read any bytes. */
    public RunWatch() {}

    /**
     * Parses the next bytes of the recording.
     *
     * @param bytes a buffer that starts with these bytes
     * @param length number of bytes
     * @throws IllegalArgumentException if they are not part of a recording of this version, or are damaged
     */
    public void push(byte[] bytes, int length) {
        state.push(bytes, length);
    }

    RecordingState state() {
        return state;
    }

    @Override
    public void happened(String text) {
        String[] words = text.split(" ", 2);
        if (KINDS.contains(words[0])) {
            addEvent(words[0], words.length > 1 ? words[1] : "");
        }
    }

    private void addEvent(String kind, String text) {
        events.add(Json.object("index", count, "kind", kind, "text", text));
    }

    @Override
    public void cycleEnded(long cycle, RecordingState state) {
        firstCycle = count == 0 ? cycle : firstCycle;
        if (!state.robots().equals(present)) {
            present = state.robots();
            upright.clear();
            cyclesOfRoster = rosters.computeIfAbsent(present, robotsThere -> new int[1]);
        }
        cyclesOfRoster[0]++;
        robots = Math.max(robots, present.size());
        ball.add(metres(state.ball(0)), metres(state.ball(1)));
        present.forEach(robot -> watch(robot, state));
        count++;
    }

    private void watch(ListedRobot robot, RecordingState state) {
        double x = metres(state.number(robot, 0));
        double y = metres(state.number(robot, 1));
        ways.computeIfAbsent(robot.id(), id -> new Trail()).add(x, y);
        sides.put(robot.id(), robot.side());
        boolean isUpright = !isFallen(robot, state);
        if (Boolean.TRUE.equals(upright.put(robot.id(), isUpright)) && !isUpright) {
            addEvent("fall", (robot.team() + " " + robot.number()).strip());
        }
    }

    private static boolean isFallen(ListedRobot robot, RecordingState state) {
        double w = state.number(robot, 3);
        double x = state.number(robot, 4);
        double y = state.number(robot, 5);
        double z = state.number(robot, 6);
        double square = w * w + x * x + y * y + z * z;
        double cosineOfTilt = square == 0 ? 1 : 1 - 2 * (x * x + y * y) / square;
        return cosineOfTilt < COSINE_OF_FALL || metres(state.number(robot, 2)) < BodyState.FALLEN_METRES;
    }

    private static double metres(long steps) {
        return steps / RecordingState.STEPS_PER_METRE;
    }

    /** {@return the number of cycles read so far} */
    public int count() {
        return count;
    }

    /**
     * Returns a summary of the part that has been read: the data that a page needs to open the recording at any cycle.
     *
     * <pre>
     * count, firstCycle     number of cycles, and the simulation cycle of the first one
     * left, right           names of the teams, empty for none
     * score                 goals of the left and the right team
     * robots                maximum number of simultaneous robots
     * pitch                 length and width of the field in metres
     * ball                  trail of the ball: x and y in metres, at equal intervals
     * ways                  trails of the robots, with their side: 0 for no team, 1 for the left team, 2 for the right team
     * events                index of the cycle, kind (goal, foul, playmode or fall) and text
     * rosters               line-ups of robots, each with its number of cycles
     * models                models of robots that are not NAOs, by the name of their type; absent if all are NAOs
     * header                header of the recording
     * </pre>
     *
     * @return the summary
     */
    public JsonObject summary() {
        JsonObject header = new JsonObject();
        state.header().forEach(header::addProperty);
        JsonObject summary = Json.object(
                "count", count,
                "firstCycle", firstCycle,
                "left", state.teams().get(0),
                "right", state.teams().get(1),
                "score", state.score(),
                "robots", robots,
                "pitch", List.of(size(header, "FieldLength", 12), size(header, "FieldWidth", 8)),
                "ball", ball.places(),
                "ways", Json.array(ways.entrySet().stream().map(this::way)),
                "events", events,
                "rosters",
                        Json.array(rosters.entrySet().stream()
                                .filter(entry -> entry.getValue()[0] > 0)
                                .map(RunWatch::roster)),
                "header", header);
        if (!state.models().isEmpty()) {
            JsonObject models = new JsonObject();
            state.models().forEach((type, model) -> models.add(type, JsonParser.parseString(model)));
            summary.add("models", models);
        }
        return summary;
    }

    private JsonObject way(Map.Entry<Integer, Trail> way) {
        return Json.object(
                "side",
                Objects.requireNonNull(sides.get(way.getKey())),
                "places",
                way.getValue().places());
    }

    private static JsonObject roster(Map.Entry<List<ListedRobot>, int[]> entry) {
        return Json.object(
                "robots", Json.array(entry.getKey().stream().map(RunWatch::member)), "cycles", entry.getValue()[0]);
    }

    private static JsonObject member(ListedRobot robot) {
        return Json.object("type", robot.typeName(), "number", robot.number(), "team", robot.team());
    }

    private static double size(JsonObject header, String name, double otherwise) {
        try {
            double value =
                    Double.parseDouble(header.has(name) ? header.get(name).getAsString() : "");
            return value > 0 && Double.isFinite(value) ? value : otherwise;
        } catch (NumberFormatException missingOrDamaged) {
            return otherwise;
        }
    }
}
