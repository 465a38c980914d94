package org.robonewbie.learning.gym;

import java.util.List;
import java.util.Map;
import java.util.function.Supplier;
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
            Map.of("Stand", GymStand::new, "Walk", GymWalk::new, "Kick", GymKick::new, "Reach", GymReach::new));

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
     * @return creates each episode
     * @throws IllegalArgumentException if one of them does not exist; the message says what there is
     */
    Supplier<GymEpisode> episodes(ClassLoader classes) {
        Supplier<GymTask> tasks = TASKS.named(task, classes);
        if (reward.isEmpty()) {
            return () -> new GymEpisode(tasks.get());
        }
        Supplier<Measure> rewards = Measures.named(reward, classes);
        return () -> new GymEpisode(tasks.get(), rewards.get());
    }
}
