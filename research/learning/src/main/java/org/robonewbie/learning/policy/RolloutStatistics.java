package org.robonewbie.learning.policy;

import java.util.List;
import java.util.Locale;
import java.util.function.Predicate;
import org.robonewbie.learning.environment.VelocityError;
import org.robonewbie.nao.Cycle;

/**
 * Statistics of episodes.
 *
 * @param rollouts the episodes, at least one
 */
public record RolloutStatistics(List<Rollout> rollouts) {

    /** Header of a CSV table of statistics, without a line terminator. */
    static final String COLUMNS = "episodes,cycles,reward,falls,speedError,turnError,successes";

    /** Stores an unmodifiable copy of the list. */
    public RolloutStatistics {
        rollouts = List.copyOf(rollouts);
    }

    double meanReturn() {
        return rollouts.stream().mapToDouble(Rollout::reward).sum() / rollouts.size();
    }

    /** {@return the number of episodes in which the robot fell} */
    public int falls() {
        return count(Rollout::fallen);
    }

    int successes() {
        return count(Rollout::success);
    }

    private int count(Predicate<Rollout> predicate) {
        return (int) rollouts.stream().filter(predicate).count();
    }

    double seconds() {
        return cycles() * Cycle.SECONDS;
    }

    private long cycles() {
        return rollouts.stream().mapToLong(Rollout::cycles).sum();
    }

    private String velocityError(String format, String none) {
        VelocityError sum =
                rollouts.stream().map(Rollout::velocityError).reduce(VelocityError.NONE, VelocityError::plus);
        return sum.windows() == 0
                ? none
                : String.format(
                        Locale.ROOT,
                        format,
                        sum.metresPerSecond() / sum.windows(),
                        sum.degreesPerSecond() / sum.windows());
    }

    /** Returns a row of the table; cells that do not apply are empty. */
    String row() {
        String errors = velocityError("%.4f,%.3f", ",");
        return String.format(
                Locale.ROOT,
                "%d,%d,%.4f,%d,%s,%d",
                rollouts.size(),
                cycles(),
                meanReturn(),
                falls(),
                errors,
                successes());
    }

    @Override
    public String toString() {
        return String.format(
                Locale.ROOT,
                "success %d of %d, %d falls, return %.3f in %.2f s on average%s",
                successes(),
                rollouts.size(),
                falls(),
                meanReturn(),
                seconds() / rollouts.size(),
                velocityError(", error %.3f m/s and %.1f degrees/s", ""));
    }
}
