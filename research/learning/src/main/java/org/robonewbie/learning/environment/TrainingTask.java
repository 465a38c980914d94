package org.robonewbie.learning.environment;

import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Stream;
import org.robonewbie.agent.policy.Policy;
import org.robonewbie.agent.policy.Quantity;
import org.robonewbie.agent.walk.GaitObservation;
import org.robonewbie.agent.walk.ResidualPolicy;
import org.robonewbie.agent.walk.SoccerPolicy;
import org.robonewbie.agent.walk.Stance;
import org.robonewbie.agent.walk.WalkVelocity;
import org.robonewbie.learning.environment.DomainRandomization.Name;
import org.robonewbie.nao.Joint;
import org.robonewbie.nao.Vector3;
import org.robonewbie.nao.geometry.Pose2d;
import org.robonewbie.nao.kinematics.BodyState;
import org.robonewbie.nao.motion.Keyframe;
import org.robonewbie.nao.motion.Motion;
import org.robonewbie.protocol.perceptor.FootForces;
import org.robonewbie.trial.Challenge;
import org.robonewbie.trial.RandomSource;
import org.robonewbie.trial.RobotStart;
import org.robonewbie.trial.Scene;
import org.robonewbie.trial.Trial;
import org.robonewbie.trial.TrialHook;
import org.robonewbie.trial.WorldState;
import org.robonewbie.trial.measure.MeasureFromStart;
import org.robonewbie.trial.measure.Pushes;

/**
 * Task of one robot in one episode of reinforcement learning. Its value as a measure is the return so far, so the reward
 * for a step is the increase in the value. A fall terminates the episode.
 *
 * <p>An action has a component between -1 and 1 for each of the task's {@link #joints}: the target angle relative to the initial posture,
 * in units of {@link #rangeDegrees}, or with the option {@code speeds} the joint's speed. Subclasses override the defaults as needed; a
 * custom task must have a public no-arg constructor.
 *
 * <pre>{@code
 * public final class Squat extends TrainingTask {
 *     private double least = 1;
 *     public double rangeDegrees() { return 60; }
 *     protected void see(WorldState first, WorldState now) { least = Math.min(least, now.robot().position().z()); }
 *     public double value() { return -least; }
 * }
 * }</pre>
 */
public abstract class TrainingTask extends MeasureFromStart implements Challenge {

    private static final List<Joint> LEGS = Arrays.stream(Joint.values())
            .filter(joint -> joint.name().matches(".*_(HIP|KNEE|FOOT)_.*"))
            .toList();
    static final Motion TO_THE_STANCE =
            new Motion("stance", List.of(new Keyframe(600, Stance.POSTURE), new Keyframe(300, Stance.POSTURE)));
    private static final int CYCLES_BETWEEN_PUSHES = 50;
    private static final double MAX_PUSH_NEWTONS = 40;
    private static final Scene STANDING = scene(1.5).withBall(2.5, 0);

    private RandomSource random = new RandomSource(0);
    private int robot;
    private boolean speeds;

    /** Creates a task for one episode. */
    protected TrainingTask() {}

    /** Creates a scene with a robot that is in its standard stance and faces the right goal. */
    static Scene scene(double x) {
        return Scene.of(RobotStart.at(x, 0).after(TO_THE_STANCE));
    }

    /** Seeds the task and creates its scene. */
    final Scene seededScene(long seed) {
        random = new RandomSource(seed);
        return scene(random);
    }

    /** Seeds a task of a robot other than the first one, which creates the scene. */
    final void seed(long seed) {
        random = new RandomSource(31 * ~seed + robot);
    }

    /**
     * {@inheritDoc}
     *
     * <p>By default, the robot stands 3 m in front of the goal with the ball 1 m ahead of it. A reset is fast if the
     * scene equals that of the previous episode, so apply small variations in {@link #begin}, not here.
     */
    @Override
    public Scene scene(RandomSource episodeRandom) {
        return STANDING;
    }

    /** {@return the random numbers of the episode} */
    protected final RandomSource random() {
        return random;
    }

    /**
     * Moves the ball by a random offset.
     *
     * @param trial the episode, at its beginning
     * @param maxMetres largest offset along each axis
     */
    protected final void scatterBall(Trial trial, double maxMetres) {
        Vector3 offset = new Vector3(random.between(-maxMetres, maxMetres), random.between(-maxMetres, maxMetres), 0);
        trial.placeBall(trial.ball().position().plus(offset));
    }

    /** Pushes the robot once from a random side with a random force. */
    final void pushOnce(Trial trial) {
        Pose2d direction = new Pose2d(0, 0, random.between(-180, 180));
        trial.robot(0).push(direction.point(random.between(0, MAX_PUSH_NEWTONS), 0, 0));
    }

    /**
     * {@return the number of learning robots, by default 1; they are the first robots of the scene, and each has its own
     * task object}
     */
    public int learners() {
        return 1;
    }

    /** {@return the index of this task's robot in the scene} */
    protected final int robot() {
        return robot;
    }

    final void setRobot(int index) {
        robot = index;
    }

    final void setSpeeds(boolean areActions) {
        speeds = areActions;
    }

    /** Returns whether actions are joint speeds instead of angles. */
    final boolean hasSpeeds() {
        return speeds;
    }

    @Override
    protected final BodyState watched(WorldState state) {
        return state.robots().get(robot);
    }

    /**
     * {@return the motion to play, which must move all joints; an action corrects its postures. By default, there is no motion, and an
     * action is relative to the initial posture}
     */
    public Optional<Motion> motion() {
        return Optional.empty();
    }

    /**
     * {@return the walking policy that the agent learns to correct: an action replaces the output of the policy's network; empty by
     * default}
     */
    public Optional<Policy> walk() {
        return Optional.empty();
    }

    /** {@return the velocity currently commanded for the {@link #walk}} */
    protected WalkVelocity velocity() {
        return WalkVelocity.ZERO;
    }

    /**
     * {@return whether an action is a velocity for the learned walk, in units of {@link SoccerPolicy#MAX}, instead of joint angles; false by
     * default. The robot gets up by itself, and an observation contains only the {@link #extraQuantities}}
     */
    public boolean steersWalk() {
        return false;
    }

    /** {@return the names and units of an action's components, which are the outputs of a policy} */
    public final List<Quantity> outputs() {
        if (steersWalk()) {
            return SoccerPolicy.OUTPUTS;
        }
        return walk().isPresent()
                ? ResidualPolicy.OUTPUTS
                : joints().stream()
                        .map(joint -> speeds
                                ? Quantity.speedOf(joint)
                                : Quantity.scaled("joint." + joint, rangeDegrees(joint), "degrees"))
                        .toList();
    }

    /**
     * {@return the bound of a learning program's actions, which are divided by it; by default 1. PPO explores with a standard deviation of 1
     * at first, so a bound of 3 makes this noise a third of the range}
     */
    public double actionLimit() {
        return 1;
    }

    /** {@return the joints that an action moves, by default those of both legs; all other joints hold still} */
    public List<Joint> joints() {
        return LEGS;
    }

    /** {@return the angle in degrees by which an action of 1 turns a joint away from the initial posture} */
    public abstract double rangeDegrees();

    /**
     * Returns the angle by which an action of 1 turns a joint away from the initial posture, by default that of all joints.
     *
     * @param joint one of the {@link #joints}
     * @return the angle in degrees
     */
    public double rangeDegrees(Joint joint) {
        return rangeDegrees();
    }

    /** {@return the number of cycles per action unless the option {@code cycles} sets it, by default 1} */
    public int cyclesPerAction() {
        return 1;
    }

    /**
     * {@return whether an observation contains the {@link GaitObservation#INPUTS} instead of the sensor readings; false by default. The
     * task must move the joints of both legs}
     */
    public boolean observesGait() {
        return false;
    }

    /** {@return the number of cycles after which an episode is truncated, by default 500 (10 s)} */
    public int longestCycles() {
        return 500;
    }

    /** {@return whether the robot observes the ball with its camera; false by default, which is faster} */
    public boolean hasCamera() {
        return false;
    }

    /** {@return the components of the observation in addition to the sensor readings, by default none} */
    public List<ObservedQuantity> extraQuantities() {
        return List.of();
    }

    /** {@return the current values of the {@link #extraQuantities}} */
    public double[] extras() {
        return new double[0];
    }

    /** {@return whether the parameters of the {@link #walk} are learned together with the network; false by default} */
    public boolean learnsGait() {
        return false;
    }

    /** {@return the accumulated error of a commanded velocity, by default none} */
    public VelocityError velocityError() {
        return VelocityError.NONE;
    }

    /** Sets the options that affect a gait. Called before the scene is created. Tasks without a gait reject these options. */
    void configure(DomainRandomization options) {
        rejectAllBut(options, Set.of());
    }

    /** Receives the contact forces on the feet in each cycle, before the task sees the world. Most tasks ignore them. */
    void feel(FootForces feet) {}

    /** Throws an exception if an option that affects a gait is set, except those that the task knows. */
    static void rejectAllBut(DomainRandomization options, Set<Name> known) {
        Stream.of(Name.SPEED, Name.STEP, Name.SLOW, Name.TOLERANCE, Name.CONSTANT, Name.FLIGHT, Name.TYPE)
                .filter(name -> !known.contains(name) && options.range(name).isPresent())
                .findFirst()
                .ifPresent(name -> {
                    throw new IllegalArgumentException("This task has no option " + name.word()
                            + ". Omit the option, or choose the task WalkGait, JogGait or RunGait.");
                });
    }

    /** Sets the policy that will act in the episode. Called before the scene is created. */
    void setPolicy(Policy policy) {}

    /** Creates the pushes of an episode: one per second, each stronger than the last. */
    TrialHook pushes(double newtons, long seed) {
        return newtons == 0 ? world -> {} : Pushes.growing(seed, CYCLES_BETWEEN_PUSHES, newtons);
    }

    /**
     * Sets a constant command for the episode, taken from the options {@code forward}, {@code left} and {@code turn}.
     *
     * @param velocity the velocity
     * @throws IllegalArgumentException if the task has no commanded velocity, which is the default
     */
    protected void setCommand(WalkVelocity velocity) {
        throw new IllegalArgumentException(
                "This task has no commanded velocity. Omit the options forward, left and turn, or choose the task"
                        + " Follow.");
    }

    /**
     * Sets the target distance for the episode, taken from the option {@code distance}.
     *
     * @param metres the distance
     * @throws IllegalArgumentException if the task has no target distance, which is the default
     */
    protected void setDistance(double metres) {
        throw new IllegalArgumentException(
                "This task has no target distance. Omit the option distance, or choose the task KickTo.");
    }

    /**
     * {@return the increase in force from one push to the next, in newtons, with one push per second; 0 (the default)
     * for no pushes}
     */
    public double pushNewtons() {
        return 0;
    }

    /** {@return what is rewarded and what is penalised, for help messages; empty by default} */
    public String rewardRule() {
        return "";
    }

    /** {@return the condition for success, for help messages} */
    public String successRule() {
        return "no fall";
    }

    /**
     * {@return whether the robot has achieved the goal of the task; training programs receive it as {@code
     * info["is_success"]}}
     */
    public boolean isDone() {
        return !hasFallen();
    }

    @Override
    public boolean isDecided() {
        return hasFallen();
    }
}
