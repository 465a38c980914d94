package org.robonewbie.learning.gym;

import java.util.Map;
import java.util.function.Supplier;
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
        String[] lines = message.split("\n", -1);
        String chosen = reward;
        for (int i = 1; i < lines.length; i++) {
            if (!lines[i].startsWith(REWARD)) {
                throw new IllegalArgumentException(
                        "There is no option \"" + lines[i] + "\". After the task there can be: " + REWARD + "MEASURE.");
            }
            chosen = lines[i].substring(REWARD.length());
        }
        return new GymOrder(lines[0].isEmpty() ? task : lines[0], chosen);
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
