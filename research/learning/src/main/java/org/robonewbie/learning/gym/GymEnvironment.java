package org.robonewbie.learning.gym;

import java.util.Arrays;
import java.util.List;
import java.util.function.Supplier;
import org.robonewbie.trial.Controller;
import org.robonewbie.trial.RandomSource;
import org.robonewbie.trial.RobotStart;
import org.robonewbie.trial.Scene;
import org.robonewbie.trial.Trial;
import org.robonewbie.trial.TrialHook;
import org.robonewbie.trial.TrialListener;
import org.robonewbie.trial.WorldState;
import org.robonewbie.trial.measure.Pushes;

/** Robots that live through episodes of a task, in a world of their own; in most tasks it is one. */
final class GymEnvironment implements AutoCloseable {

    private static final int CYCLES_BETWEEN_PUSHES = 50;

    private final Supplier<List<GymEpisode>> episodes;
    private final List<ObservedQuantity> quantities;
    private GymOptions options;
    private List<GymLearner> learners;
    private int cyclesPerAction = 1;
    private int cycles;
    private TrialListener listener = TrialListener.NONE;
    private Scene scene;
    private Trial trial;
    private WorldState now;

    /** Begins the episode with seed 0 of tasks as they are. */
    GymEnvironment(Supplier<List<GymEpisode>> episodes) {
        this(episodes, GymOptions.NONE);
    }

    /** Begins the episode with seed 0. */
    GymEnvironment(Supplier<List<GymEpisode>> episodes, GymOptions options) {
        this.options = options;
        this.episodes = episodes;
        learners = newLearners();
        quantities = learners.get(0).quantities();
        scene = task().scene(new RandomSource(0));
        trial = Trial.direct(scene, 0, cast());
        now = trial.now();
        begin(0);
    }

    private List<GymLearner> newLearners() {
        List<GymEpisode> all = episodes.get();
        return all.stream()
                .map(episode -> new GymLearner(episode.task().robot(), episode))
                .toList();
    }

    /** What is observed by each robot; values beyond the ranges are clamped. */
    List<ObservedQuantity> quantities() {
        return quantities;
    }

    /** The task of the present episode, that of the first robot if there are several. */
    GymTask task() {
        return learners.get(0).task();
    }

    /** How many robots learn. */
    int robots() {
        return learners.size();
    }

    /** Names of the robots that learn: their team and number. */
    List<String> names() {
        return scene.robots().stream().limit(robots()).map(GymEnvironment::name).toList();
    }

    private static String name(RobotStart robot) {
        return robot.team() + "_" + robot.number();
    }

    /** Begins an episode that is chosen by the seed. */
    void reset(long seed) {
        learners = newLearners();
        Scene next = task().scene(new RandomSource(seed));
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
        cyclesPerAction = checkedCycles(drawn.cycles());
        cycles = 0;
        WorldState first = trial.now();
        learners.forEach(learner -> learner.stand(first));
        drawn.apply(trial);
        GymTask task = task();
        drawn.command().ifPresent(task::takeCommand);
        drawn.distance().ifPresent(task::takeDistance);
        task.begin(trial);
        TrialHook pushes = pushes(drawn.pushNewtons().orElse(task.pushNewtons()), seed);
        trial.with(world -> {
            pushes.act(world);
            task.act(world);
        });
        now = trial.now();
        learners.forEach(learner -> learner.begin(now, trial.readings(learner.robot()), drawn, seed));
        listener.cycleEnded(trial);
    }

    private int checkedCycles(int wanted) {
        if (wanted > 1 && task().walk().isPresent()) {
            throw new IllegalArgumentException(
                    "In this task an action corrects one cycle of a walk. Leave out cycles.");
        }
        return wanted;
    }

    private static TrialHook pushes(double newtons, long seed) {
        return newtons == 0 ? world -> {} : new Pushes(seed, CYCLES_BETWEEN_PUSHES, newtons);
    }

    /** Changes the episodes that begin from now on. */
    void setOptions(GymOptions changed) {
        options = changed;
    }

    /** Lets somebody watch all that happens from now on. */
    void setAudience(TrialListener watching) {
        listener = watching;
        listener.cycleEnded(trial);
    }

    /** The robots that learn, and others that hold still. */
    private Controller[] cast() {
        Controller[] cast = new Controller[scene.robots().size()];
        Arrays.setAll(cast, i -> i < robots() ? learners.get(i).controller() : Controller.ofSpeeds());
        return cast;
    }

    /** Lets the only robot act. */
    void step(double... action) {
        act(new double[][] {action});
    }

    /** Lets each robot act for as many cycles as an action lasts, or until the episode is over. */
    void act(double[]... actions) {
        learners.forEach(GymLearner::beginReward);
        int run = 0;
        do {
            runCycle(actions);
            run++;
        } while (run < cyclesPerAction && !isOver());
    }

    private void runCycle(double[][] actions) {
        for (int robot = 0; robot < learners.size(); robot++) {
            learners.get(robot).act(actions[robot]);
        }
        now = trial.step();
        for (GymLearner learner : learners) {
            learner.see(now, trial.readings(learner.robot()));
        }
        cycles++;
        listener.cycleEnded(trial);
    }

    /** What the first robot perceives. */
    double[] observation() {
        return observation(0);
    }

    /** What a robot perceives. */
    double[] observation(int robot) {
        return learners.get(robot).observation(quantities);
    }

    /** What is true now. */
    WorldState now() {
        return now;
    }

    /** What is true of a robot now, in the order of {@link GymTruth#NAMES}. */
    double[] truth(int robot) {
        return GymTruth.of(
                now,
                trial.robot(robot).torsoVelocity(),
                robot,
                learners.get(robot).task());
    }

    /** The reward of the first robot for the last action. */
    double reward() {
        return reward(0);
    }

    /** The reward of a robot for the last action. */
    double reward(int robot) {
        return learners.get(robot).reward();
    }

    /** Whether the episode has ended. */
    boolean isOver() {
        return learners.stream().anyMatch(GymLearner::isOver);
    }

    /** How many cycles the episode has lasted so far. */
    int cycles() {
        return cycles;
    }

    /** Whether the episode has lasted as long as its task lasts. */
    boolean isLate() {
        return cycles >= task().longestCycles();
    }

    @Override
    public void close() {
        trial.close();
    }
}
