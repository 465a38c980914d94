package org.robonewbie.learning.gym;

import java.util.Arrays;
import java.util.List;
import java.util.function.Supplier;
import java.util.stream.Stream;
import org.robonewbie.trial.Audience;
import org.robonewbie.trial.Chance;
import org.robonewbie.trial.Moment;
import org.robonewbie.trial.Performer;
import org.robonewbie.trial.Scene;
import org.robonewbie.trial.Trial;

/** One robot that lives through episodes of a task, in a world of its own. */
final class GymEnvironment implements AutoCloseable {

    /** Robots pass their stops by a little, and errors of sensors come on top. */
    private static final double ROOM = 0.1;

    private final Supplier<GymEpisode> episodes;
    private final List<ObservedQuantity> quantities;
    private GymOptions options;
    private GymEpisode episode;
    private Perception perception;
    private ReadingErrors errors = ReadingErrors.NONE;
    private Audience audience = Audience.NOBODY;
    private Scene scene;
    private Trial trial;

    /** Begins the episode with seed 0 of tasks as they are. */
    GymEnvironment(Supplier<GymEpisode> episodes) {
        this(episodes, GymOptions.NONE);
    }

    /** Begins the episode with seed 0. */
    GymEnvironment(Supplier<GymEpisode> episodes, GymOptions options) {
        this.options = options;
        this.episodes = episodes;
        episode = episodes.get();
        perception = new Perception(task().hasCamera());
        quantities = Stream.concat(perception.quantities().stream(), task().extraQuantities().stream())
                .map(quantity -> quantity.widened(ROOM))
                .toList();
        scene = task().scene(new Chance(0));
        trial = Trial.direct(scene, 0, cast());
        begin(0);
    }

    /** What is observed; values beyond the ranges are clamped. */
    List<ObservedQuantity> quantities() {
        return quantities;
    }

    /** The task of the present episode. */
    GymTask task() {
        return episode.task();
    }

    /** Begins an episode that is chosen by the seed. */
    void reset(long seed) {
        episode = episodes.get();
        perception = new Perception(task().hasCamera());
        Scene next = task().scene(new Chance(seed));
        if (next.equals(scene)) {
            trial.reset(seed, cast());
        } else {
            trial.close();
            scene = next;
            trial = Trial.direct(scene, seed, cast());
        }
        begin(seed);
    }

    private void begin(long seed) {
        GymOptions.Drawn drawn = options.draw(seed);
        errors = new ReadingErrors(drawn.noise(), seed);
        episode.begin(trial, drawn, seed);
        audience.cycleEnded(trial);
    }

    /** Changes the episodes that begin from now on. */
    void setOptions(GymOptions changed) {
        options = changed;
    }

    /** Lets somebody watch all that happens from now on. */
    void setAudience(Audience watching) {
        audience = watching;
        audience.cycleEnded(trial);
    }

    /** The robot that learns, and others that hold still. */
    private Performer[] cast() {
        Performer[] cast = new Performer[scene.robots().size()];
        Arrays.setAll(cast, i -> i == 0 ? episode : Performer.ofSpeeds());
        return cast;
    }

    /** Runs one cycle. */
    void step(double... action) {
        episode.step(trial, action);
        audience.cycleEnded(trial);
    }

    /** What the robot perceives; to be asked once after each reset and each step. */
    double[] observation() {
        double[] felt = errors.added(perception.observe(trial.readings(0)));
        double[] extras = task().extras();
        double[] all = Arrays.copyOf(felt, felt.length + extras.length);
        System.arraycopy(extras, 0, all, felt.length, extras.length);
        Arrays.setAll(all, i -> quantities.get(i).clamped(all[i]));
        return all;
    }

    /** What is true now. */
    Moment now() {
        return trial.now();
    }

    /** What is true now, in the order of {@link GymTruth#NAMES}. */
    double[] truth() {
        return GymTruth.of(trial, task());
    }

    /** The reward of the last step. */
    double reward() {
        return episode.reward();
    }

    /** Whether the episode has ended. */
    boolean isOver() {
        return episode.isOver();
    }

    @Override
    public void close() {
        trial.close();
    }
}
