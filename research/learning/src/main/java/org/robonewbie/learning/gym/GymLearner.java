package org.robonewbie.learning.gym;

import java.util.Arrays;
import java.util.List;
import java.util.stream.Stream;
import org.robonewbie.agent.policy.MotionGuide;
import org.robonewbie.trial.Controller;
import org.robonewbie.trial.SensorReadings;
import org.robonewbie.trial.WorldState;

/** One robot that learns, in one episode: what it does, perceives and earns. */
final class GymLearner {

    /** Robots pass their stops by a little, and errors of sensors come on top. */
    private static final double ROOM = 0.1;

    private final int robot;
    private final GymEpisode episode;
    private final Perception perception;
    private ReadingErrors errors = ReadingErrors.NONE;
    private double[] felt = {};

    GymLearner(int robot, GymEpisode episode) {
        this.robot = robot;
        this.episode = episode;
        this.perception = new Perception(task().hasCamera());
    }

    GymTask task() {
        return episode.task();
    }

    Controller controller() {
        return episode;
    }

    /** What is observed; values beyond the ranges are clamped. */
    List<ObservedQuantity> quantities() {
        if (task().walk().isPresent()) {
            return WalkGuide.QUANTITIES;
        }
        Stream<ObservedQuantity> progress = task().motion().isPresent()
                ? MotionGuide.PROGRESS.stream().map(one -> new ObservedQuantity(one.name(), one.unit(), -1, 1))
                : Stream.empty();
        return Stream.of(perception.quantities().stream(), progress, task().extraQuantities().stream())
                .flatMap(all -> all)
                .map(quantity -> quantity.widened(ROOM))
                .toList();
    }

    int robot() {
        return robot;
    }

    /** Takes the first posture, from which actions are counted. */
    void stand(WorldState state) {
        episode.stand(state);
    }

    /** Begins the episode; the scene is complete. */
    void begin(WorldState first, SensorReadings readings, GymOptions.Drawn drawn, long seed) {
        errors = new ReadingErrors(drawn.noise(), seed + robot);
        episode.begin(first, drawn.delayCycles());
        feel(readings);
    }

    /** Chooses what the robot does in the next cycle. */
    void act(double... action) {
        episode.act(action);
    }

    /** Begins to count what the robot earns by one action. */
    void beginReward() {
        episode.beginReward();
    }

    /** Looks at what came of a cycle. */
    void see(WorldState state, SensorReadings readings) {
        episode.see(state);
        feel(readings);
    }

    private void feel(SensorReadings readings) {
        felt = errors.added(perception.observe(readings));
        episode.feel(felt);
    }

    /** What the robot perceives now. */
    double[] observation(List<ObservedQuantity> quantities) {
        double[] all =
                task().walk().isPresent() ? episode.progress() : joined(felt, episode.progress(), task().extras());
        for (int i = 0; i < all.length; i++) {
            all[i] = quantities.get(i).clamped(all[i]);
        }
        return all;
    }

    private static double[] joined(double[] first, double[] second, double[] third) {
        double[] all = Arrays.copyOf(first, first.length + second.length + third.length);
        System.arraycopy(second, 0, all, first.length, second.length);
        System.arraycopy(third, 0, all, first.length + second.length, third.length);
        return all;
    }

    /** The reward of the last action. */
    double reward() {
        return episode.reward();
    }

    /** Whether there is nothing more to earn. */
    boolean isOver() {
        return episode.isOver();
    }
}
