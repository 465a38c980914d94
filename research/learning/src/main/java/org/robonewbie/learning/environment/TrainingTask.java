package org.robonewbie.learning.environment;

import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.stream.Stream;
import org.robonewbie.agent.policy.Policy;
import org.robonewbie.agent.policy.Quantity;
import org.robonewbie.agent.walk.ResidualPolicy;
import org.robonewbie.agent.walk.Stance;
import org.robonewbie.agent.walk.WalkVelocity;
import org.robonewbie.learning.environment.DomainRandomization.Name;
import org.robonewbie.nao.Joint;
import org.robonewbie.nao.Vector3;
import org.robonewbie.nao.kinematics.BodyState;
import org.robonewbie.nao.motion.Keyframe;
import org.robonewbie.nao.motion.Motion;
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
 * Something to learn for one robot of a scene, in one episode. Its value as a measure is the return so far: the reward of a step is
 * the growth of the value. An episode is terminated when the robot has fallen.
 *
 * <p>An action has a number between -1 and 1 for each of the task's {@link #joints}: the angle to go to, as a part of {@link
 * #rangeDegrees} from the first posture. Subclasses say what is different; a task of your own needs a public constructor without
 * parameters.
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
    private static final Scene STANDING = scene(1.5).withBall(2.5, 0);

    private RandomSource random = new RandomSource(0);
    private int robot;

    /** Creates a task for one episode. */
    protected TrainingTask() {}

    /** Sets a scene with a robot in the stance, which faces the right goal. */
    static Scene scene(double x) {
        return Scene.of(RobotStart.at(x, 0).after(TO_THE_STANCE));
    }

    /**
     * {@inheritDoc}
     *
     * <p>A robot stands 3 m from the goal, the ball 1 m ahead. An episode begins at once if its scene equals that of the episode
     * before; {@link #begin} is the better place for small differences.
     */
    @Override
    public Scene scene(RandomSource ofTheEpisode) {
        random = ofTheEpisode;
        return STANDING;
    }

    /** {@return what differs from episode to episode} */
    protected final RandomSource random() {
        return random;
    }

    /**
     * Moves the ball a little, so that episodes differ.
     *
     * @param trial the episode, at its beginning
     * @param metres how far at most along each axis
     */
    protected final void scatterBall(Trial trial, double metres) {
        Vector3 way = new Vector3(random.between(-metres, metres), random.between(-metres, metres), 0);
        trial.placeBall(trial.ball().position().plus(way));
    }

    /**
     * {@return how many robots learn, 1 unless a subclass says otherwise: the first ones of the scene, each with a task object of its own}
     */
    public int learners() {
        return 1;
    }

    /** {@return the index in the scene of the robot whose task this is} */
    protected final int robot() {
        return robot;
    }

    /** Gives the task to another robot than the first one. */
    final void setRobot(int index) {
        robot = index;
    }

    @Override
    protected final BodyState watched(WorldState state) {
        return state.robots().get(robot);
    }

    /**
     * {@return the motion that an action corrects while it plays: angles are counted from where it wants the joints, and all joints
     * follow it; none unless a subclass says otherwise}
     */
    public Optional<Motion> motion() {
        return Optional.empty();
    }

    /**
     * {@return the walk that an action corrects: the engine with this policy's numbers, and the action takes the place of what its
     * network gives; none unless a subclass says otherwise}
     */
    public Optional<Policy> walk() {
        return Optional.empty();
    }

    /** {@return the velocity that the {@link #walk} is asked for now} */
    protected WalkVelocity velocity() {
        return WalkVelocity.ZERO;
    }

    /** {@return names and units of an action, and with it of the outputs of a policy} */
    public final List<Quantity> outputs() {
        String unit = String.format(Locale.ROOT, "%.0f degrees", rangeDegrees());
        return walk().isPresent()
                ? ResidualPolicy.OUTPUTS
                : joints().stream()
                        .map(joint -> new Quantity("joint." + joint, unit))
                        .toList();
    }

    /** {@return the joints that an action moves, those of both legs; the others stay as they are} */
    public List<Joint> joints() {
        return LEGS;
    }

    /** {@return the angle by which an action of 1 differs from the first posture} */
    public abstract double rangeDegrees();

    /** {@return the number of cycles after which an episode ends, 10 s} */
    public int longestCycles() {
        return 500;
    }

    /** {@return whether the robot observes the ball with its camera; without it a task is faster} */
    public boolean hasCamera() {
        return false;
    }

    /** {@return what is observed besides the perceptors} */
    public List<ObservedQuantity> extraQuantities() {
        return List.of();
    }

    /** {@return the present values of the {@link #extraQuantities}} */
    public double[] extras() {
        return new double[0];
    }

    /**
     * {@return whether policies of this task carry the numbers of the {@link #walk}, so that they are learned with the network; false
     * unless a subclass says otherwise}
     */
    public boolean learnsGait() {
        return false;
    }

    /** {@return errors of a commanded velocity; none unless a subclass says otherwise} */
    public VelocityError velocityError() {
        return VelocityError.NONE;
    }

    /** Takes the options of a gait before the scene is set; a task without a gait refuses them. */
    void configure(DomainRandomization options) {
        Stream.of(Name.SPEED, Name.STEP, Name.SLOW, Name.TOLERANCE, Name.CONSTANT, Name.TYPE, Name.SECONDS)
                .filter(name -> options.range(name).isPresent())
                .findFirst()
                .ifPresent(name -> {
                    throw new IllegalArgumentException("This task has no option " + name.word()
                            + ". Leave it out, or choose the task WalkGait, JogGait or RunGait.");
                });
    }

    /** Takes the policy that will act, before the scene is set. */
    void takePolicy(Policy policy) {}

    /** Pushes of an episode: once per second, each time harder. */
    TrialHook pushes(double newtons, long seed) {
        return newtons == 0 ? world -> {} : Pushes.growing(seed, CYCLES_BETWEEN_PUSHES, newtons);
    }

    /**
     * Takes a velocity to follow in the whole episode, which the options {@code forward}, {@code left} and {@code turn} have set.
     *
     * @param command the velocity
     * @throws IllegalArgumentException if the task follows no command, as most
     */
    protected void takeCommand(WalkVelocity command) {
        throw new IllegalArgumentException(
                "This task follows no command. Leave out forward, left and turn, or choose the task Follow.");
    }

    /**
     * Takes the distance that is wanted in the whole episode, which the option {@code distance} has set.
     *
     * @param metres the distance
     * @throws IllegalArgumentException if the task wants none, as most
     */
    protected void takeDistance(double metres) {
        throw new IllegalArgumentException("This task wants no distance. Leave it out, or choose the task KickTo.");
    }

    /** {@return by how much pushes that come once per second get harder each time, in newtons; 0 for none} */
    public double pushNewtons() {
        return 0;
    }

    /** {@return whether the robot has done what the task wants; learning programs find it in {@code info["is_success"]}} */
    public boolean isDone() {
        return !hasFallen();
    }

    @Override
    public boolean isDecided() {
        return hasFallen();
    }
}
