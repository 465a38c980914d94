package org.robonewbie.studio;

import com.google.gson.Gson;
import com.google.gson.JsonObject;
import com.google.gson.JsonParser;
import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStreamReader;
import java.io.PrintStream;
import java.net.BindException;
import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import java.util.HashMap;
import java.util.Map;
import java.util.Objects;
import java.util.stream.Collectors;
import org.robonewbie.nao.Joint;
import org.robonewbie.nao.Vector3;
import org.robonewbie.nao.kinematics.BodyState;
import org.robonewbie.simulator.RobotSnapshot;
import org.robonewbie.simulator.WorldSnapshot;

/**
 * Opens studios for the tests of the pages, which are JavaScript. Each line of the standard input is a request as a JSON object and is
 * answered by a line: <code>{"do":"open","folder":"/tmp/a"}</code> by <code>{"id":1}</code>. The process ends when its input ends.
 */
final class Stage {

    private final Map<Integer, StagedStudio> studios = new HashMap<>();
    private int opened;

    private Stage() {}

    public static void main(String[] args) throws IOException {
        PrintStream answers = System.out;
        System.setOut(System.err); // only answers are written to the standard output
        Stage stage = new Stage();
        BufferedReader requests = new BufferedReader(new InputStreamReader(System.in, StandardCharsets.UTF_8));
        for (String line = requests.readLine(); line != null; line = requests.readLine()) {
            answers.println(new Gson().toJson(stage.answer(line)));
        }
        Runtime.getRuntime().halt(0); // programs and simulators of a failed test may still run
    }

    private Map<String, Object> answer(String line) {
        try {
            return answer(JsonParser.parseString(line).getAsJsonObject());
        } catch (IOException | RuntimeException | AssertionError failed) {
            return Map.of("error", failed.toString());
        }
    }

    private Map<String, Object> answer(JsonObject request) throws IOException {
        if (request.get("do").getAsString().equals("open")) {
            StagedStudio studio = open(request);
            opened++;
            studios.put(opened, studio);
            return Map.of(
                    "id", opened, "agentPort", studio.simulation().agentPort(), "drawingPort", studio.drawingPort());
        }
        int id = request.get("id").getAsInt();
        StagedStudio studio = studio(id);
        return switch (request.get("do").getAsString()) {
            case "address" -> Map.of("address", studio.address());
            case "world" -> world(studio.simulation().latest());
            case "order" -> {
                studio.order(request.get("order").toString());
                yield Map.of();
            }
            case "pageFile" ->
                Map.of("path", studio.pageFile(request.get("folder").getAsString()));
            case "wall" -> {
                studio.wall().tell(request, trial -> studio(trial).simulation());
                yield Map.of();
            }
            case "tell" -> {
                studio.tell(request.get("line").getAsString());
                yield Map.of();
            }
            case "foul" -> {
                studio.callFoul();
                yield Map.of();
            }
            case "end" -> {
                studio.close();
                yield Map.of();
            }
            case "restart" -> {
                studios.put(id, studio.restarted(request));
                yield Map.of();
            }
            case "search" -> studio.search().answer(request.getAsJsonObject("news"));
            case "close" -> {
                studios.remove(id);
                studio.close();
                yield Map.of();
            }
            default -> throw new IllegalArgumentException("unknown: " + request);
        };
    }

    /** Opens a studio; tries again if another process has the port for telemetry, which follows that for agents. */
    private static StagedStudio open(JsonObject request) throws IOException {
        try {
            return new StagedStudio(request);
        } catch (BindException portIsTaken) {
            return new StagedStudio(request);
        }
    }

    private StagedStudio studio(int id) {
        return Objects.requireNonNull(studios.get(id), "no studio " + id);
    }

    private static Map<String, Object> world(WorldSnapshot now) {
        return Map.of(
                "cycle", now.cycle(),
                "isPaused", now.paused(),
                "speed", String.valueOf(now.speed()),
                "playMode", now.playMode().name(),
                "score", now.scoreLeft() + ":" + now.scoreRight(),
                "ball", point(now.ballPosition()),
                "robots", now.robots().stream().map(Stage::robot).toList());
    }

    private static Map<String, Object> robot(RobotSnapshot robot) {
        BodyState body = robot.body();
        return Map.of(
                "team", robot.team(),
                "number", robot.number(),
                "place", point(body.position()),
                "heading", body.headingDegrees(),
                "degrees", Arrays.stream(Joint.values()).collect(Collectors.toMap(Joint::name, body::degrees)));
    }

    private static Map<String, Double> point(Vector3 place) {
        return Map.of("x", place.x(), "y", place.y(), "z", place.z());
    }
}
