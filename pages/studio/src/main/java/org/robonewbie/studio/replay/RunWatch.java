package org.robonewbie.studio.replay;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import org.robonewbie.nao.kinematics.BodyState;
import org.robonewbie.simulator.recording.ListedRobot;
import org.robonewbie.simulator.recording.RecordingState;

/** Builds the summary of a recording while it is being read. */
final class RunWatch implements RecordingState.Listener {

    private static final List<String> KINDS = List.of("goal", "foul", "playmode");
    private static final double COSINE_OF_FALL = Math.cos(Math.toRadians(BodyState.FALLEN_DEGREES));

    private final List<RunSummary.Event> events = new ArrayList<>();
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

    @Override
    public void happened(String text) {
        String[] words = text.split(" ", 2);
        if (KINDS.contains(words[0])) {
            events.add(new RunSummary.Event(count, words[0], words.length > 1 ? words[1] : ""));
        }
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
            events.add(new RunSummary.Event(count, "fall", (robot.team() + " " + robot.number()).strip()));
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
    int count() {
        return count;
    }

    RunSummary summary(RecordingState state) {
        Map<String, String> header = state.header();
        return new RunSummary(
                count,
                firstCycle,
                state.teams().get(0),
                state.teams().get(1),
                state.score(),
                robots,
                List.of(number(header, "FieldLength", 12), number(header, "FieldWidth", 8)),
                ball.places(),
                ways.entrySet().stream()
                        .map(way -> new RunSummary.Way(
                                Objects.requireNonNull(sides.get(way.getKey())),
                                way.getValue().places()))
                        .toList(),
                List.copyOf(events),
                rosters.entrySet().stream()
                        .filter(entry -> entry.getValue()[0] > 0)
                        .map(RunWatch::roster)
                        .toList(),
                header);
    }

    private static RunSummary.Roster roster(Map.Entry<List<ListedRobot>, int[]> entry) {
        List<RunSummary.Member> members = entry.getKey().stream()
                .map(robot -> new RunSummary.Member(robot.type().name(), robot.number(), robot.team()))
                .toList();
        return new RunSummary.Roster(members, entry.getValue()[0]);
    }

    private static double number(Map<String, String> header, String name, double otherwise) {
        try {
            double value = Double.parseDouble(String.valueOf(header.get(name)));
            return value > 0 && Double.isFinite(value) ? value : otherwise;
        } catch (NumberFormatException missingOrDamaged) {
            return otherwise;
        }
    }
}
