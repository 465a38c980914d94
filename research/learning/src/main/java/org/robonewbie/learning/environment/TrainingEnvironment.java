package org.robonewbie.learning.environment;

import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.function.Supplier;
import org.robonewbie.agent.policy.Policy;
import org.robonewbie.learning.environment.DomainRandomization.Name;
import org.robonewbie.trial.Controller;
import org.robonewbie.trial.ExternalPhysics;
import org.robonewbie.trial.Scene;
import org.robonewbie.trial.Trial;
import org.robonewbie.trial.TrialHook;
import org.robonewbie.trial.TrialListener;
import org.robonewbie.trial.WorldState;

/**
 * Environment for reinforcement learning: a world in which one robot, or several in some tasks, performs episodes of a
 * task.
 *
 * <pre>{@code
 * environment.reset(1, Optional.empty());
 * while (!environment.isTerminated() && !environment.isTruncated()) {
 *     environment.step(network.apply(environment.observation()));
 *     undiscountedReturn += environment.reward();
 * }
 * }</pre>
 */
public final class TrainingEnvironment implements AutoCloseable {

    private final Supplier<List<EpisodeRunner>> episodes;
    private final List<ObservedQuantity> quantities;
    private final Optional<Supplier<ExternalPhysics>> physics;
    private DomainRandomization options;
    private List<EpisodeRunner> runners;
    private int cyclesPerAction = 1;
    private int cycles;
    private TrialListener listener = TrialListener.NONE;
    private Scene scene;
    private Trial trial;
    private WorldState now;

    /** Creates an environment and begins the episode with seed 0. */
    TrainingEnvironment(Supplier<List<EpisodeRunner>> episodes, DomainRandomization options) {
        this(episodes, options, Optional.empty());
    }

    /**
     * Creates an environment and begins the episode with seed 0.
     *
     * @param physics creates the physics engine of each episode; empty for the simulator's own
     */
    TrainingEnvironment(
            Supplier<List<EpisodeRunner>> episodes,
            DomainRandomization options,
            Optional<Supplier<ExternalPhysics>> physics) {
        this.options = options;
        this.episodes = episodes;
        this.physics = physics;
        runners = newRunners(Optional.empty());
        quantities = runners.get(0).quantities();
        scene = task().seededScene(0);
        trial = Trial.direct(scene, 0, controllers());
        now = trial.now();
        begin(0);
    }

    private List<EpisodeRunner> newRunners(Optional<Policy> policy) {
        List<EpisodeRunner> all = episodes.get();
        all.forEach(runner -> {
            runner.configure(options);
            policy.ifPresent(runner.task()::setPolicy);
        });
        return all;
    }

    /** {@return the components of each robot's observation, which is clamped to their ranges} */
    public List<ObservedQuantity> quantities() {
        return quantities;
    }

    /** {@return the task of the current episode; that of the first robot if several robots are learning} */
    public TrainingTask task() {
        return runners.get(0).task();
    }

    /** Returns the number of learning robots. */
    int robots() {
        return runners.size();
    }

    /** Returns the names of the learning robots, such as {@code left_1}. */
    List<String> names() {
        return scene.robots().stream()
                .limit(robots())
                .map(robot -> robot.team() + "_" + robot.number())
                .toList();
    }

    void reset(long seed) {
        reset(seed, Optional.empty());
    }

    /**
     * Begins an episode.
     *
     * @param seed the seed of the episode
     * @param policy the policy that will act in the episode; if the policy contains a gait, the robot walks with that
     *     gait
     */
    public void reset(long seed, Optional<Policy> policy) {
        runners = newRunners(policy);
        Scene next = task().seededScene(seed);
        runners.stream().skip(1).forEach(runner -> runner.task().seed(seed));
        if (next.equals(scene)) {
            trial.reset(seed, controllers());
        } else {
            trial.close();
            scene = next;
            trial = Trial.direct(scene, seed, controllers());
        }
        begin(seed);
    }

    private void begin(long seed) {
        TrainingTask task = task();
        DomainRandomization drawn =
                options.withDefaultCycles(task.cyclesPerAction()).draw(seed);
        cyclesPerAction = drawn.cycles();
        if (cyclesPerAction > 1 && task.walk().isPresent()) {
            throw new IllegalArgumentException(
                    "An action of this task corrects a single cycle of a walk. Omit the option \"cycles\".");
        }
        cycles = 0;
        WorldState first = trial.now();
        runners.forEach(runner -> runner.captureFirstPosture(first));
        drawn.apply(trial);
        TrialHook body = BodyRandomization.apply(trial, drawn, seed);
        drawn.command().ifPresent(task::setCommand);
        drawn.range(Name.DISTANCE).ifPresent(distance -> task.setDistance(distance.low()));
        task.begin(trial);
        TrialHook pushes = task.pushes(drawn.of(Name.PUSH, task.pushNewtons()), seed);
        trial.with(world -> {
            body.act(world);
            pushes.act(world);
            task.act(world);
        });
        physics.map(Supplier::get).ifPresent(trial::setPhysics);
        now = trial.now();
        runners.forEach(runner -> runner.begin(now, trial.readings(runner.task().robot()), drawn, seed));
        listener.cycleEnded(trial);
    }

    /**
     * Sets the options for all subsequent episodes.
     *
     * @param newOptions the options
     */
    public void setOptions(DomainRandomization newOptions) {
        options.requireSameSpaces(newOptions);
        options = newOptions;
    }

    /** Sets the listener for all subsequent cycles. */
    void setListener(TrialListener newListener) {
        listener = newListener;
        listener.cycleEnded(trial);
    }

    /** Returns a controller for each robot. Robots that do not learn hold still. */
    private Controller[] controllers() {
        Controller[] controllers = new Controller[scene.robots().size()];
        Arrays.setAll(controllers, i -> i < robots() ? runners.get(i) : Controller.ofSpeeds());
        return controllers;
    }

    /**
     * Applies the action of the only learning robot for the number of cycles per action, or until the episode is
     * terminated.
     *
     * @param action values from -1 to 1; see {@link TrainingTask}
     */
    public void step(double... action) {
        act(new double[][] {action});
    }

    /** Applies one action for each learning robot. */
    void act(double[]... actions) {
        for (int robot = 0; robot < runners.size(); robot++) {
            runners.get(robot).beginAction(actions[robot]);
        }
        int run = 0;
        do {
            runCycle();
            run++;
        } while (run < cyclesPerAction && !isTerminated());
    }

    private void runCycle() {
        runners.forEach(EpisodeRunner::act);
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

    double[] observation(int robot) {
        return runners.get(robot).observation(quantities);
    }

    WorldState now() {
        return now;
    }

    /** Returns the true state of a robot, in the order of {@link PrivilegedState#NAMES}. */
    double[] privilegedState(int robot) {
        return PrivilegedState.of(
                now, trial.robot(robot).torsoVelocity(), runners.get(robot).task());
    }

    /** {@return whether the option {@code true_state} is set} */
    boolean hasTrueState() {
        return options.of(Name.TRUE_STATE, 0) > 0;
    }

    /** Returns the complete true state of a robot, in the order of {@link TrueState#QUANTITIES}. */
    float[] trueState(int robot) {
        return TrueState.of(trial.robot(runners.get(robot).task().robot()), trial.ball());
    }

    /** {@return the reward of the first robot for the last action} */
    public double reward() {
        return reward(0);
    }

    double reward(int robot) {
        return runners.get(robot).reward();
    }

    /** {@return whether the task has ended the episode, for example because of a fall} */
    public boolean isTerminated() {
        return runners.stream().anyMatch(EpisodeRunner::isTerminated);
    }

    /** Returns the number of cycles per action. */
    int cyclesPerAction() {
        return cyclesPerAction;
    }

    /** {@return the number of cycles of the episode so far} */
    public int cycles() {
        return cycles;
    }

    /** {@return whether the episode has reached its maximum length} */
    public boolean isTruncated() {
        return cycles >= longestCycles();
    }

    /** Returns the number of cycles after which an episode is truncated. */
    int longestCycles() {
        return options.longestCycles(task());
    }

    @Override
    public void close() {
        trial.close();
    }
}
