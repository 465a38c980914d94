package org.robonewbie.studio.replay;

import com.google.gson.Gson;
import java.io.IOException;
import java.nio.file.Path;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.robonewbie.nao.Vector3;
import org.robonewbie.simulator.RobotSnapshot;
import org.robonewbie.simulator.WorldSnapshot;
import org.robonewbie.simulator.file.RecordingFile;
import org.robonewbie.simulator.recording.RecordedCycle;
import org.robonewbie.simulator.recording.RecordingReader;

/**
 * What people want to know of a recording before they open it.
 *
 * @param seconds its length
 * @param left name of the left team, empty if there was none
 * @param right name of the right team, empty if there was none
 * @param score goals of the left and of the right team at the end
 * @param robots how many robots took part at most at the same time
 * @param events how often something happened, such as a goal, by its kind
 * @param pitch length and width of the field in metres
 * @param ball place of the ball in the last cycle with a robot
 * @param places of the robots in that cycle: x, y, and 0 for the left team or 1 for the right
 */
record RecordingCard(
        double seconds,
        String left,
        String right,
        List<Integer> score,
        int robots,
        Map<String, Integer> events,
        List<Double> pitch,
        List<Double> ball,
        List<List<Double>> places) {

    private static final double CYCLE_SECONDS = 0.02;
    private static final List<String> TOLD_EVENTS = List.of("goal", "foul");

    /** Reads a whole recording, or what there is of it. */
    static RecordingCard of(Path recording) throws IOException {
        try (RecordingReader reader = RecordingFile.read(recording)) {
            Summary summary = new Summary();
            for (Optional<RecordedCycle> cycle = reader.next(); cycle.isPresent(); cycle = reader.next()) {
                summary.add(cycle.get());
            }
            return summary.card(reader.header());
        }
    }

    /** {@return the card as JSON} */
    String json() {
        return new Gson().toJson(this);
    }

    /** What is known after some of the cycles. */
    private static final class Summary {

        private final Map<String, Integer> events = new LinkedHashMap<>();
        private final Map<Integer, Boolean> fallen = new HashMap<>();
        private Optional<WorldSnapshot> last = Optional.empty();
        private Optional<WorldSnapshot> peopled = Optional.empty();
        private int cycles;
        private int robots;

        void add(RecordedCycle cycle) {
            WorldSnapshot world = cycle.snapshot();
            cycles++;
            last = Optional.of(world);
            peopled = world.robots().isEmpty() ? peopled : last;
            robots = Math.max(robots, world.robots().size());
            cycle.events().stream()
                    .map(text -> text.split(" ", 2)[0])
                    .filter(TOLD_EVENTS::contains)
                    .forEach(this::count);
            world.robots().forEach(this::watchFall);
        }

        private void watchFall(RobotSnapshot robot) {
            boolean isFallen = robot.body().isFallen();
            if (Boolean.FALSE.equals(fallen.put(robot.id(), isFallen)) && isFallen) {
                count("fall");
            }
        }

        private void count(String kind) {
            events.merge(kind, 1, Integer::sum);
        }

        RecordingCard card(Map<String, String> header) {
            List<Double> pitch = List.of(number(header, "FieldLength", 12), number(header, "FieldWidth", 8));
            return new RecordingCard(
                    cycles * CYCLE_SECONDS,
                    last.map(WorldSnapshot::teamLeft).orElse(""),
                    last.map(WorldSnapshot::teamRight).orElse(""),
                    last.map(world -> List.of(world.scoreLeft(), world.scoreRight()))
                            .orElse(List.of(0, 0)),
                    robots,
                    events,
                    pitch,
                    peopled.map(world -> flat(world.ballPosition())).orElse(List.of(0.0, 0.0)),
                    peopled.map(WorldSnapshot::robots).orElse(List.of()).stream()
                            .map(Summary::place)
                            .toList());
        }

        private static double number(Map<String, String> header, String name, double otherwise) {
            return Optional.ofNullable(header.get(name)).map(Double::valueOf).orElse(otherwise);
        }

        private static List<Double> place(RobotSnapshot robot) {
            Vector3 at = robot.body().position();
            return List.of(
                    at.x(), at.y(), (double) robot.side().map(Enum::ordinal).orElse(0));
        }

        private static List<Double> flat(Vector3 place) {
            return List.of(place.x(), place.y());
        }
    }
}
