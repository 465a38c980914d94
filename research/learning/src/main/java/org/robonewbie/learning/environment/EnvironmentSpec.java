package org.robonewbie.learning.environment;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.SortedMap;
import java.util.TreeMap;
import java.util.function.Supplier;
import java.util.stream.IntStream;
import org.robonewbie.trial.Measure;
import org.robonewbie.trial.measure.Catalogue;
import org.robonewbie.trial.measure.Measures;

/**
 * Specification of an environment: a task and its options.
 *
 * @param task name of a task such as {@code Walk}, or of a class that extends {@link TrainingTask}
 * @param options options of its episodes, each {@code NAME=VALUE}; see docs/gym-protocol.md
 */
public record EnvironmentSpec(String task, List<String> options) {

    private static final String REWARD = "reward=";
    private static final Map<String, Supplier<TrainingTask>> ALL = Map.ofEntries(
            Map.entry("Stand", StandTraining::new),
            Map.entry("Follow", FollowTraining::new),
            Map.entry("Run", RunTraining::new),
            Map.entry("EngineFollow", EngineFollowTraining::new),
            Map.entry("EngineRun", EngineRunTraining::new),
            Map.entry("WalkGait", GaitTraining::walking),
            Map.entry("JogGait", GaitTraining::jogging),
            Map.entry("RunGait", GaitTraining::running),
            Map.entry("GetUp", GetUpTraining::new),
            Map.entry("QuickGetUp", QuickGetUpTraining::new),
            Map.entry("Walk", WalkTraining::new),
            Map.entry("Kick", KickTraining::new),
            Map.entry("KickTo", KickToTraining::new),
            Map.entry("Reach", ReachTraining::new),
            Map.entry("Match1v1", () -> MatchTraining.of(1)),
            Map.entry("Match2v2", () -> MatchTraining.of(2)),
            Map.entry("Match11v11", () -> MatchTraining.of(11)),
            Map.entry("KeeperAgainstAttacker", MatchTraining::keeperAgainstAttacker));
    private static final Catalogue<TrainingTask> TASKS = new Catalogue<>("task", TrainingTask.class, ALL);

    /** Stores an unmodifiable copy of the list. */
    public EnvironmentSpec {
        options = List.copyOf(options);
    }

    /** {@return a new task of each kind, by name} */
    public static SortedMap<String, TrainingTask> tasks() {
        SortedMap<String, TrainingTask> tasks = new TreeMap<>();
        ALL.forEach((name, task) -> tasks.put(name, task.get()));
        return tasks;
    }

    /** {@return descriptions of the options, by name} */
    public static Map<String, String> meaningOfOptions() {
        Map<String, String> meanings = new LinkedHashMap<>();
        for (DomainRandomization.Name name : DomainRandomization.Name.values()) {
            meanings.put(name.word(), name.meaning());
        }
        meanings.put(
                "reward",
                "a measure whose increase replaces the reward (decrease if less is better): an objective of"
                        + " robonewbie optimise, or a custom class");
        return meanings;
    }

    /**
     * Returns the name of the measure that replaces the task's own reward, such as {@code energy}; empty to keep the
     * task's reward.
     */
    String reward() {
        return options.stream()
                .filter(option -> option.startsWith(REWARD))
                .reduce("", (before, option) -> option.substring(REWARD.length()));
    }

    /**
     * Parses all options except the reward.
     *
     * @return the options
     * @throws IllegalArgumentException if an option does not exist or its value is invalid
     */
    public DomainRandomization randomization() {
        return DomainRandomization.of(
                options.stream().filter(option -> !option.startsWith(REWARD)).toList());
    }

    /**
     * Creates an environment.
     *
     * @param classes the class loader for custom tasks and measures
     * @return the environment at the start of its first episode
     * @throws IllegalArgumentException if the task, the reward or an option does not exist; the message lists the valid
     *     names
     */
    public TrainingEnvironment create(ClassLoader classes) {
        return new TrainingEnvironment(runners(classes), randomization());
    }

    /** Returns a supplier that creates the runners of each episode, one for each learning robot. */
    Supplier<List<EpisodeRunner>> runners(ClassLoader classes) {
        Supplier<TrainingTask> tasks = TASKS.named(task, classes);
        Optional<Supplier<Measure>> rewards =
                reward().isEmpty() ? Optional.empty() : Optional.of(Measures.named(reward(), classes));
        if (rewards.isPresent() && tasks.get().learners() > 1) {
            throw new IllegalArgumentException("The reward " + reward() + " measures a single robot, but " + task
                    + " trains several. Omit the reward.");
        }
        return () -> IntStream.range(0, tasks.get().learners())
                .mapToObj(robot -> runner(tasks.get(), robot, rewards))
                .toList();
    }

    private static EpisodeRunner runner(TrainingTask task, int robot, Optional<Supplier<Measure>> rewards) {
        task.setRobot(robot);
        return new EpisodeRunner(task, rewards.map(Supplier::get).orElse(task));
    }
}
