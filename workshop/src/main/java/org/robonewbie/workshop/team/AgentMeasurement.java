package org.robonewbie.workshop.team;

import java.io.IOException;
import java.io.OutputStream;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.Random;
import java.util.function.Function;
import java.util.function.Supplier;
import java.util.stream.Collectors;
import org.robonewbie.agent.Agent;
import org.robonewbie.examples.Agent_BetterSoccer;
import org.robonewbie.examples.Agent_SimpleSoccer;
import org.robonewbie.examples.Agent_SimpleWalkToBall;
import org.robonewbie.nao.file.AtomicFile;
import org.robonewbie.nao.geometry.Pose2d;
import org.robonewbie.trial.Controller;
import org.robonewbie.trial.Measure;
import org.robonewbie.trial.RobotStart;
import org.robonewbie.trial.Scene;
import org.robonewbie.trial.Trial;
import org.robonewbie.trial.WorldState;
import org.robonewbie.trial.measure.SustainedCondition;
import org.robonewbie.trial.measure.TimeToScore;

/** Plays many games with each example agent, each game with its own seed, and reports how many games succeed. */
public final class AgentMeasurement {

    private static final String TITLE = """
            | agent | successes | median | success |
            |---|---|---|---|""";
    private static final double NEAR_METRES = 0.6;
    private static final double NEAR_SECONDS = 4;

    /** Start pose of both soccer players; see their {@code defaults()}. */
    private static final Pose2d DEFAULT_START = new Pose2d(-0.5, 0.4, -40);

    private final int trials;
    private final long firstSeed;
    private final PrintStream out;

    /** Task of one agent; it succeeds if the measure is decided in time. */
    private record Task(
            String name,
            String rule,
            Supplier<Agent> agent,
            double seconds,
            Function<Random, Pose2d> start,
            Supplier<Measure> measure) {

        /** Returns the simulated seconds until success; empty after a failure. */
        OptionalDouble play(long seed) {
            Scene scene = Scene.of(RobotStart.at(start.apply(new Random(seed))));
            Measure needed = measure.get();
            try (Trial trial = Trial.served(scene, seed, Controller.ofAgent(agent.get()))) {
                trial.run(seconds, needed);
            }
            return needed.isDecided() ? OptionalDouble.of(needed.value()) : OptionalDouble.empty();
        }
    }

    /** Results for one agent. */
    private record Result(Task task, int trials, List<Double> seconds) {

        double median() {
            List<Double> sorted = seconds.stream().sorted().toList();
            int failures = trials - sorted.size();
            int middle = (trials - 1) / 2;
            return middle < trials - failures ? sorted.get(middle) : Double.POSITIVE_INFINITY;
        }

        String json() {
            String median = Double.isFinite(median()) ? String.format(Locale.ROOT, "%.1f", median()) : "null";
            return String.format(
                    Locale.ROOT,
                    "{\"name\":\"%s\",\"trials\":%d,\"successes\":%d,\"median\":%s,\"unit\":\"s\"}",
                    task.name,
                    trials,
                    seconds.size(),
                    median);
        }

        @Override
        public String toString() {
            String median = Double.isFinite(median()) ? String.format(Locale.ROOT, "%.1f s", median()) : "-";
            return String.format(
                    Locale.ROOT, "| `%s` | %d of %d | %s | %s |", task.name, seconds.size(), trials, median, task.rule);
        }
    }

    /**
     * Creates a measurement.
     *
     * @param trials number of games per agent
     * @param firstSeed seed of the first game
     * @param out destination of the table
     */
    public AgentMeasurement(int trials, long firstSeed, PrintStream out) {
        this.trials = trials;
        this.firstSeed = firstSeed;
        this.out = out;
    }

    /**
     * Plays all games and prints a Markdown table.
     *
     * @param part substring of the names of the agents to measure; empty for all
     * @param json file for the results; empty for none
     * @throws IOException if the file cannot be written
     * @throws IllegalArgumentException if no name contains the substring
     */
    public void run(String part, Optional<Path> json) throws IOException {
        List<Task> chosen =
                tasks().stream().filter(task -> task.name.contains(part)).toList();
        if (chosen.isEmpty()) {
            throw new IllegalArgumentException("No measured agent's name contains \"" + part + "\".");
        }
        List<Result> results = measure(chosen);
        if (json.isPresent()) {
            write(json.get(), results);
        }
    }

    private List<Result> measure(List<Task> tasks) {
        List<Result> results = tasks.stream().map(this::measure).toList();
        out.println(TITLE);
        results.forEach(out::println);
        return results;
    }

    /** {@return the task of each measured agent, keyed by its name, in the order of the printed table} */
    public static Map<String, String> rules() {
        Map<String, String> rules = new LinkedHashMap<>();
        tasks().forEach(task -> rules.put(task.name, task.rule));
        return rules;
    }

    private static List<Task> tasks() {
        return List.of(
                new Task(
                        "Agent_SimpleWalkToBall",
                        "stays within 0.6 m of the ball for 4 s, from any place and direction in its half",
                        Agent_SimpleWalkToBall::new,
                        180,
                        AgentMeasurement::anywhere,
                        () -> new SustainedCondition(NEAR_SECONDS, AgentMeasurement::isAtBall)),
                new Task(
                        "Agent_SimpleSoccer",
                        "scores from the usual start within 20 minutes",
                        Agent_SimpleSoccer::new,
                        1200,
                        random -> DEFAULT_START,
                        TimeToScore::new),
                new Task(
                        "Agent_BetterSoccer",
                        "scores from the usual start within 5 minutes",
                        Agent_BetterSoccer::new,
                        300,
                        random -> DEFAULT_START,
                        TimeToScore::new));
    }

    private static boolean isAtBall(WorldState state) {
        return state.robot().isStanding() && state.place().distance(state.ball()) < NEAR_METRES;
    }

    private Result measure(Task task) {
        List<Double> seconds = new ArrayList<>();
        for (int trial = 1; trial <= trials; trial++) {
            OptionalDouble needed = quietly(task, firstSeed + trial - 1);
            needed.ifPresent(seconds::add);
            String result = needed.isPresent() ? String.format(Locale.ROOT, "%.1f s", needed.getAsDouble()) : "failed";
            out.println(task.name + " " + trial + "/" + trials + ": " + result);
        }
        return new Result(task, trials, seconds);
    }

    private static OptionalDouble quietly(Task task, long seed) {
        PrintStream usual = System.out;
        System.setOut(new PrintStream(OutputStream.nullOutputStream(), false, StandardCharsets.UTF_8));
        try {
            return task.play(seed);
        } finally {
            System.setOut(usual);
        }
    }

    /** Returns a random pose in the robot's own half, away from the ball in the centre. */
    private static Pose2d anywhere(Random random) {
        double x = -0.8 - 3.7 * random.nextDouble();
        double y = -3 + 6 * random.nextDouble();
        return new Pose2d(x, y, random.nextInt(360) - 180);
    }

    private static void write(Path file, List<Result> results) throws IOException {
        String text = results.stream().map(Result::json).collect(Collectors.joining(",\n ", "{\"agents\":[", "]}\n"));
        AtomicFile.write(file, text);
    }
}
