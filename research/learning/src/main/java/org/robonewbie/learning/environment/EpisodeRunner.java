package org.robonewbie.learning.environment;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Deque;
import java.util.List;
import java.util.Optional;
import java.util.Random;
import java.util.stream.DoubleStream;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import org.robonewbie.agent.policy.MotionGuide;
import org.robonewbie.agent.walk.GaitObservation;
import org.robonewbie.agent.walk.PolicyWalk;
import org.robonewbie.agent.walk.SoccerPolicy;
import org.robonewbie.learning.environment.DomainRandomization.Name;
import org.robonewbie.nao.Joint;
import org.robonewbie.nao.TeamSide;
import org.robonewbie.nao.motion.JointStates;
import org.robonewbie.nao.motion.Motors;
import org.robonewbie.nao.motion.Posture;
import org.robonewbie.protocol.effector.EffectorCommand;
import org.robonewbie.trial.Controller;
import org.robonewbie.trial.Measure;
import org.robonewbie.trial.SensorReadings;
import org.robonewbie.trial.WorldState;

/** Runs one episode for one learning robot: applies its actions, updates its observation and accumulates its reward. */
final class EpisodeRunner implements Controller {

    private static final List<Joint> ALL_JOINTS = List.of(Joint.values());

    /** Relative margin of the observation ranges, for joints that overshoot their stops and for sensor noise. */
    private static final double MARGIN = 0.1;

    /**
     * Number of readings affected by the option {@code noise}: joint angles, gyroscope and accelerometer. They come first in an
     * observation.
     */
    private static final int NOISY_READINGS = Joint.COUNT + 6;

    private static final List<ObservedQuantity> GAIT =
            ObservedQuantity.symmetric(GaitObservation.INPUTS, GaitObservation.MAX);

    private final TrainingTask task;
    private final Measure measure;
    private final Optional<SteeredAgent> steered;
    private final Controller motor;
    private final JointStates joints = new JointStates();
    private final Motors motors = new Motors(joints);
    private final Perception perception;
    private final GaitObservation gait = new GaitObservation();
    private Random noise = new Random(0);
    private double noiseSigma;
    private double[] perceived = {};
    private Posture firstPosture = Posture.ZERO;
    private Optional<MotionGuide> guide = Optional.empty();
    private Optional<WalkGuide> walk = Optional.empty();
    private int cycles;
    private ActionLatency latency = new ActionLatency(0, 0, new Random(0));
    private double[] action = {};
    private double[] chosen = {};
    private int history = 1;
    private final Deque<double[]> past = new ArrayDeque<>();
    private double value;
    private double reward;

    /**
     * Creates a runner that rewards increases in a measure, or decreases if smaller values are better. The measure may
     * be the task itself.
     */
    EpisodeRunner(TrainingTask task, Measure measure) {
        this.task = task;
        this.measure = measure;
        this.perception = new Perception(task.hasCamera());
        steered = task.steersWalk() ? Optional.of(new SteeredAgent()) : Optional.empty();
        motor = steered.map(Controller::ofAgent).orElseGet(() -> Controller.ofPolicy(this::speeds));
    }

    TrainingTask task() {
        return task;
    }

    /** Sets the options of all episodes. Call before the scene is created. */
    void configure(DomainRandomization options) {
        history = (int) options.of(Name.HISTORY, 1);
        task.setSpeeds(options.of(Name.SPEEDS, 0) > 0);
        if (task.walk().isPresent() && history > 1) {
            throw new IllegalArgumentException(
                    "The observation of this task is that of the walk engine. Omit the option history.");
        }
        if (task.hasSpeeds() && (task.walk().isPresent() || task.motion().isPresent() || task.steersWalk())) {
            throw new IllegalArgumentException(
                    "An action of this task steers or corrects a walk or a motion. Omit the option speeds.");
        }
        task.configure(options);
    }

    List<ObservedQuantity> quantities() {
        List<ObservedQuantity> current = currentQuantities();
        return IntStream.range(0, history)
                .boxed()
                .flatMap(age -> current.stream().map(quantity -> quantity.ago(age)))
                .toList();
    }

    private List<ObservedQuantity> currentQuantities() {
        if (task.walk().isPresent()) {
            return WalkGuide.QUANTITIES;
        }
        if (task.steersWalk()) {
            return task.extraQuantities();
        }
        if (task.observesGait()) {
            return Stream.concat(GAIT.stream(), task.extraQuantities().stream()).toList();
        }
        Stream<ObservedQuantity> progress = task.motion().isPresent()
                ? MotionGuide.PROGRESS.stream().map(one -> new ObservedQuantity(one.name(), one.unit(), -1, 1))
                : Stream.empty();
        return Stream.of(perception.quantities().stream(), progress, task.extraQuantities().stream())
                .flatMap(all -> all)
                .map(quantity -> quantity.widened(MARGIN))
                .toList();
    }

    /** Stores the initial posture, to which actions are relative. */
    void captureFirstPosture(WorldState first) {
        firstPosture = first.robots().get(task.robot()).joints();
        guide = task.motion().map(motion -> new MotionGuide(motion, firstPosture));
        walk = task.walk().map(policy -> new WalkGuide(new PolicyWalk(policy).style(), motors, task.learnsGait()));
    }

    /** Begins the episode. Call when the scene is complete. */
    void begin(WorldState first, SensorReadings readings, DomainRandomization options, long seed) {
        noise = new Random(31 * ~(seed + task.robot()) + 5);
        noiseSigma = options.of(Name.NOISE, 0);
        latency = new ActionLatency(
                (int) Math.round(options.of(Name.DELAY, 0)),
                (int) Math.round(options.of(Name.JITTER, 0)),
                new Random(31 * ~(seed + task.robot()) + 13),
                new double[task.outputs().size()]);
        chosen = new double[task.outputs().size()];
        see(first, readings);
        reward = 0;
    }

    /** Sends the current action to the motors, which it reaches in the next cycle unless there is a delay. */
    void act() {
        action = latency.send(chosen);
    }

    /** Keeps the observation, begins an action, whose components are clamped to [-1, 1], and sets the reward to 0. */
    void beginAction(double... newAction) {
        if (history > 1) {
            past.addFirst(row());
            if (past.size() == history) {
                past.removeLast();
            }
        }
        chosen = Arrays.stream(newAction)
                .map(part -> Math.max(-1, Math.min(1, part)))
                .toArray();
        reward = 0;
    }

    /** Adds the reward for a cycle and updates the observation. */
    void see(WorldState now, SensorReadings readings) {
        double before = value;
        task.feel(readings.feet());
        task.see(now);
        if (measure != task) {
            measure.see(now);
        }
        value = measure.isLargerBetter() ? measure.value() : -measure.value();
        reward += value - before;
        perceived = perception.observe(readings);
        for (int i = 0; i < NOISY_READINGS && noiseSigma > 0; i++) {
            perceived[i] += noiseSigma * noise.nextGaussian();
        }
        if (task.observesGait()) {
            gait.update(
                    Perception.posture(perceived),
                    Perception.torso(perceived),
                    Perception.leftFoot(perceived),
                    Perception.rightFoot(perceived));
        }
        walk.ifPresent(one -> one.plan(task.velocity(), perceived));
    }

    /** Returns the current observation, clamped to the ranges of the quantities. */
    double[] observation(List<ObservedQuantity> quantities) {
        double[] now = row();
        double[] all = history > 1 ? withHistory(now) : now;
        Arrays.setAll(all, i -> quantities.get(i).clamped(all[i]));
        return all;
    }

    private double[] withHistory(double... now) {
        List<double[]> rows = new ArrayList<>(past);
        rows.add(0, now);
        double[] all = new double[history * now.length];
        for (int age = 0; age < history; age++) {
            double[] row = rows.get(Math.min(age, rows.size() - 1));
            System.arraycopy(row, 0, all, age * now.length, now.length);
        }
        return all;
    }

    private double[] row() {
        return walk.map(WalkGuide::inputs)
                .orElseGet(() -> sensed().flatMapToDouble(DoubleStream::of).toArray());
    }

    private Stream<double[]> sensed() {
        if (task.steersWalk()) {
            return Stream.of(task.extras());
        }
        return task.observesGait()
                ? Stream.of(gait.values(chosen), task.extras())
                : Stream.of(perceived, motionProgress(), task.extras());
    }

    private double[] motionProgress() {
        return guide.map(one -> one.progress(cycles)).orElse(new double[0]);
    }

    double reward() {
        return reward;
    }

    boolean isTerminated() {
        return task.isDecided() || measure.isDecided();
    }

    @Override
    public void introduce(String team, int number, TeamSide side) {
        motor.introduce(team, number, side);
    }

    @Override
    public List<EffectorCommand> respond(SensorReadings readings) {
        if (action.length > 0) {
            steered.ifPresent(agent -> agent.steer(SoccerPolicy.velocity(action)));
        }
        return motor.respond(readings);
    }

    private double[] speeds(SensorReadings readings) {
        readings.sense(joints);
        if (action.length > 0) {
            walk.ifPresentOrElse(one -> one.move(action), () -> move(action));
        }
        motors.endCycle();
        return motors.sentDegreesPerSecond();
    }

    private void move(double... parts) {
        cycles++;
        if (task.hasSpeeds()) {
            for (int i = 0; i < parts.length; i++) {
                Joint joint = task.joints().get(i);
                motors.setSpeed(joint, parts[i] * joint.maxDegreesPerSecond());
            }
            return;
        }
        double[] degrees =
                guide.map(one -> one.posture(cycles)).orElse(firstPosture).toArray();
        for (int i = 0; i < parts.length; i++) {
            Joint joint = task.joints().get(i);
            degrees[joint.ordinal()] += parts[i] * task.rangeDegrees(joint);
        }
        for (Joint joint : guide.isPresent() ? ALL_JOINTS : task.joints()) {
            motors.setTarget(joint, joint.clampDegrees(degrees[joint.ordinal()]), joint.maxDegreesPerSecond());
        }
    }

    @Override
    public boolean readsMessages() {
        return task.hasCamera();
    }
}
