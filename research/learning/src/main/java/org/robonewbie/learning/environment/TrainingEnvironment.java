package org.robonewbie.learning.environment;

import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.function.Supplier;
import org.robonewbie.agent.policy.Policy;
import org.robonewbie.trial.Controller;
import org.robonewbie.trial.RandomSource;
import org.robonewbie.trial.RobotStart;
import org.robonewbie.trial.Scene;
import org.robonewbie.trial.Trial;
import org.robonewbie.trial.TrialHook;
import org.robonewbie.trial.TrialListener;
import org.robonewbie.trial.WorldState;

/**
 * A world in which robots play episodes of a task; in most tasks it is one robot.
 *
 * <pre>{@code
 * environment.reset(1, Optional.empty());
 * while (!environment.isTerminated() && !environment.isTruncated()) {
 *     environment.step(network.apply(environment.observation()));
 *     total += environment.reward();
 * }
 * }</pre>
 */
public final class TrainingEnvironment implements AutoCloseable {

    private final Supplier<List<EpisodeRunner>> episodes;
    private final List<ObservedQuantity> quantities;
    private DomainRandomization options;
    private List<EpisodeRunner> runners;
    private int cyclesPerAction = 1;
    private int cycles;
    private TrialListener listener = TrialListener.NONE;
    private Scene scene;
    private Trial trial;
    private WorldState now;

    /** Begins the episode with seed 0. */
    TrainingEnvironment(Supplier<List<EpisodeRunner>> episodes, DomainRandomization options) {
        this.options = options;
        this.episodes = episodes;
        runners = newRunners(Optional.empty());
        quantities = runners.get(0).quantities();
        scene = task().scene(new RandomSource(0));
        trial = Trial.direct(scene, 0, cast());
        now = trial.now();
        begin(0);
    }

    private List<EpisodeRunner> newRunners(Optional<Policy> policy) {
        List<EpisodeRunner> all = episodes.get();
        all.forEach(runner -> {
            runner.task().configure(options);
            policy.ifPresent(runner.task()::takePolicy);
        });
        return all;
    }

    /** {@return what is observed by each robot; values beyond the ranges are clamped} */
    public List<ObservedQuantity> quantities() {
        return quantities;
    }

    /** {@return the task of the present episode, that of the first robot if there are several} */
    public TrainingTask task() {
        return runners.get(0).task();
    }

    /** How many robots learn. */
    int robots() {
        return runners.size();
    }

    /** Names of the robots that learn: their team and number. */
    List<String> names() {
        return scene.robots().stream()
                .limit(robots())
                .map(TrainingEnvironment::name)
                .toList();
    }

    private static String name(RobotStart robot) {
        return robot.team() + "_" + robot.number();
    }

    /** Begins the episode of a seed. */
    void reset(long seed) {
        reset(seed, Optional.empty());
    }

    /**
     * Begins an episode.
     *
     * @param seed chooses the episode
     * @param policy what will act in it; a task whose policies carry a gait walks with that gait
     */
    public void reset(long seed, Optional<Policy> policy) {
        runners = newRunners(policy);
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
        DomainRandomization.Sample sample = options.draw(seed);
        cyclesPerAction = checkedCycles(sample.cycles());
        cycles = 0;
        WorldState first = trial.now();
        runners.forEach(runner -> runner.stand(first));
        sample.apply(trial);
        TrainingTask task = task();
        sample.command().ifPresent(task::takeCommand);
        sample.distance().ifPresent(task::takeDistance);
        task.begin(trial);
        TrialHook pushes = task.pushes(sample.pushNewtons().orElse(task.pushNewtons()), seed);
        trial.with(world -> {
            pushes.act(world);
            task.act(world);
        });
        now = trial.now();
        runners.forEach(runner -> runner.begin(now, trial.readings(runner.task().robot()), sample, seed));
        listener.cycleEnded(trial);
    }

    private int checkedCycles(int wanted) {
        if (wanted > 1 && task().walk().isPresent()) {
            throw new IllegalArgumentException(
                    "In this task an action corrects one cycle of a walk. Leave out cycles.");
        }
        return wanted;
    }

    /**
     * Changes the episodes that begin from now on.
     *
     * @param changed the options
     */
    public void setOptions(DomainRandomization changed) {
        options = changed;
    }

    /** Sets a listener for all cycles from now on. */
    void setListener(TrialListener watching) {
        listener = watching;
        listener.cycleEnded(trial);
    }

    /** The robots that learn, and others that hold still. */
    private Controller[] cast() {
        Controller[] cast = new Controller[scene.robots().size()];
        Arrays.setAll(cast, i -> i < robots() ? runners.get(i) : Controller.ofSpeeds());
        return cast;
    }

    /**
     * Lets the only robot act, for as many cycles as an action lasts, or until the episode is terminated.
     *
     * @param action numbers from -1 to 1, see {@link TrainingTask}
     */
    public void step(double... action) {
        act(new double[][] {action});
    }

    /** Lets each robot act. */
    void act(double[]... actions) {
        runners.forEach(EpisodeRunner::beginReward);
        int run = 0;
        do {
            runCycle(actions);
            run++;
        } while (run < cyclesPerAction && !isTerminated());
    }

    private void runCycle(double[][] actions) {
        for (int robot = 0; robot < runners.size(); robot++) {
            runners.get(robot).act(actions[robot]);
        }
        now = trial.step();
        for (EpisodeRunner runner : runners) {
            runner.see(now, trial.readings(runner.task().robot()));
        }
        cycles++;
        listener.cycleEnded(trial);
    }

    /** {@return the observation of the first robot, a new array} */
    public double[] observation() {
        return observation(0);
    }

    /** The observation of a robot. */
    double[] observation(int robot) {
        return runners.get(robot).observation(quantities);
    }

    /** The true state. */
    WorldState now() {
        return now;
    }

    /** The true state of a robot, in the order of {@link PrivilegedState#NAMES}. */
    double[] privilegedState(int robot) {
        return PrivilegedState.of(
                now, trial.robot(robot).torsoVelocity(), runners.get(robot).task());
    }

    /** {@return the reward of the first robot for the last action} */
    public double reward() {
        return reward(0);
    }

    /** The reward of a robot for the last action. */
    double reward(int robot) {
        return runners.get(robot).reward();
    }

    /** {@return whether the task has ended the episode, such as by a fall} */
    public boolean isTerminated() {
        return runners.stream().anyMatch(EpisodeRunner::isTerminated);
    }

    /** {@return how many cycles the episode has lasted so far} */
    public int cycles() {
        return cycles;
    }

    /** {@return whether the time of the episode is over} */
    public boolean isTruncated() {
        return cycles >= task().longestCycles();
    }

    @Override
    public void close() {
        trial.close();
    }
}
