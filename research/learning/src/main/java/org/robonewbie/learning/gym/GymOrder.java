package org.robonewbie.learning.gym;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Supplier;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import org.robonewbie.trial.Measure;
import org.robonewbie.trial.measure.Catalogue;
import org.robonewbie.trial.measure.Measures;

/**
 * What a learning program asks for: a task, and what its steps are rewarded with.
 *
 * @param task name of a task such as {@code Walk}, or of a class that extends {@link GymTask}
 * @param reward name of a measure such as {@code energy}, or of a class that implements {@link Measure}; empty for the task's own
 */
public record GymOrder(String task, String reward) {

    private static final String REWARD = "reward=";
    private static final Catalogue<GymTask> TASKS = new Catalogue<>(
            "task",
            GymTask.class,
            Map.ofEntries(
                    Map.entry("Stand", GymStand::new),
                    Map.entry("Follow", GymFollow::new),
                    Map.entry("Run", GymRun::new),
                    Map.entry("EngineFollow", GymEngineFollow::new),
                    Map.entry("EngineRun", GymEngineRun::new),
                    Map.entry("GetUp", GymGetUp::new),
                    Map.entry("QuickGetUp", GymQuickGetUp::new),
                    Map.entry("Walk", GymWalk::new),
                    Map.entry("Kick", GymKick::new),
                    Map.entry("KickTo", GymKickTo::new),
                    Map.entry("Reach", GymReach::new),
                    Map.entry("Match1v1", () -> GymMatch.of(1)),
                    Map.entry("Match2v2", () -> GymMatch.of(2)),
                    Map.entry("Match11v11", () -> GymMatch.of(11)),
                    Map.entry("KeeperAgainstAttacker", GymMatch::keeperAgainstAttacker)));

    /** The order of a program as it comes in a message; what it leaves out is taken from this one. */
    GymOrder completing(String message) {
        List<String> lines = message.lines().toList();
        String wanted = lines.isEmpty() ? "" : lines.get(0);
        String chosen = lines.stream()
                .skip(1)
                .filter(line -> line.startsWith(REWARD))
                .reduce(reward, (before, line) -> line.substring(REWARD.length()));
        return new GymOrder(wanted.isEmpty() ? task : wanted, chosen);
    }

    /** What the same message, or one of its own, changes about episodes. */
    static GymOptions options(Stream<String> lines) {
        return lines.filter(line -> !line.startsWith(REWARD))
                .map(line -> line.split("=", 2))
                .reduce(GymOptions.NONE, (options, part) -> options.with(part[0], part[part.length - 1]), (a, b) -> b);
    }

    /**
     * Looks up task and reward.
     *
     * @param classes where to look for classes
     * @return creates each episode, for each robot that learns
     * @throws IllegalArgumentException if one of them does not exist; the message says what there is
     */
    Supplier<List<GymEpisode>> episodes(ClassLoader classes) {
        Supplier<GymTask> tasks = TASKS.named(task, classes);
        Optional<Supplier<Measure>> rewards =
                reward.isEmpty() ? Optional.empty() : Optional.of(Measures.named(reward, classes));
        if (rewards.isPresent() && tasks.get().learners() > 1) {
            throw new IllegalArgumentException(
                    "The reward " + reward + " looks at one robot, but several learn in " + task + ". Leave it out.");
        }
        return () -> IntStream.range(0, tasks.get().learners())
                .mapToObj(robot -> episode(tasks.get(), robot, rewards))
                .toList();
    }

    private static GymEpisode episode(GymTask task, int robot, Optional<Supplier<Measure>> rewards) {
        task.setRobot(robot);
        return rewards.map(reward -> new GymEpisode(task, reward.get())).orElseGet(() -> new GymEpisode(task));
    }
}
