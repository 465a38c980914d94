package org.robonewbie.learning.motion;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Queue;
import java.util.Random;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.ConcurrentLinkedQueue;
import java.util.function.BooleanSupplier;
import java.util.function.Consumer;
import java.util.function.Supplier;
import org.robonewbie.agent.walk.PolicyWalk;
import org.robonewbie.agent.walk.Stance;
import org.robonewbie.agent.walk.WalkReflex;
import org.robonewbie.agent.walk.WalkStyle;
import org.robonewbie.agent.walk.WalkVelocity;
import org.robonewbie.nao.Cycle;
import org.robonewbie.nao.Vector3;
import org.robonewbie.nao.geometry.Pose2d;
import org.robonewbie.nao.geometry.Translation2d;
import org.robonewbie.nao.kinematics.BodyState;
import org.robonewbie.nao.model.RobotType;
import org.robonewbie.nao.motion.Keyframe;
import org.robonewbie.nao.motion.Motion;
import org.robonewbie.nao.motion.Posture;
import org.robonewbie.trial.Measure;
import org.robonewbie.trial.RobotStart;
import org.robonewbie.trial.Scene;
import org.robonewbie.trial.Trial;
import org.robonewbie.trial.WorldState;
import org.robonewbie.trial.measure.BalanceMetrics;
import org.robonewbie.trial.measure.Pushes;
import org.robonewbie.trial.measure.Turn;

/**
 * Scripted trial in which a robot plays motions and walks, step by step. Most trials begin with the robot in its
 * {@linkplain org.robonewbie.agent.walk.Stance standard stance}. Positions are relative to the pose at the beginning of
 * the measurement. By default, a fall ends the trial, and later steps have no effect.
 *
 * <pre>{@code
 * try (MotionTrial trial = MotionTrial.inStance(seed, 3)) {
 *     trial.play(walk);
 *     boolean good = trial.play(stop) && trial.endsInStance();
 * }
 * }</pre>
 */
public final class MotionTrial implements AutoCloseable {

    /** A robot of the standard type at the default position of trials on the beginners' pitch. */
    public static final RobotStart ROBOT = RobotStart.at(-4.5, 1.5);

    /** Ball position that keeps the ball out of the robot's way. */
    public static final Vector3 BALL_ASIDE = new Vector3(0, -3.5, 0);

    private static final double NOISE_DEGREES = 1;
    private static final double BALL_ERROR_METRES = 0.01;
    private static final double SETTLING_SECONDS = 0.6;
    private static final double MAX_SECONDS_TO_STOP = 3;
    private static final double MAX_SECONDS = 60;
    private static final double POSTURE_DEGREES = 3;
    private static final double UPRIGHT_DEGREES = 12;
    private static final double REST_METRES_PER_SECOND = 0.05;

    /** Pools of unused direct trials, keyed by robot type; resetting a trial is much faster than creating one. */
    private static final Map<RobotType, Queue<Trial>> IDLE = new ConcurrentHashMap<>();

    private final Trial trial;
    private final ScriptedRobot robot;
    private final Consumer<Trial> end;
    private final List<Measure> measures = new ArrayList<>();
    private WorldState start;
    private BalanceMetrics balance = new BalanceMetrics();
    private Turn turn = new Turn();
    private boolean endsWithFall;

    private MotionTrial(Trial trial, ScriptedRobot robot, Consumer<Trial> end) {
        this.trial = trial;
        this.robot = robot;
        this.end = end;
        this.start = trial.now();
    }

    /** Creates a trial of a robot that stands with all joints at 0, without noise or a referee. */
    static MotionTrial standing(RobotType type, WalkStyle style) {
        ScriptedMotors robot = new ScriptedMotors(new PolicyWalk(style, WalkReflex.NONE));
        Queue<Trial> idle = IDLE.computeIfAbsent(type, key -> new ConcurrentLinkedQueue<>());
        Trial trial = idle.poll();
        if (trial == null) {
            Scene scene = Scene.of(ROBOT.withType(type)).withBall(BALL_ASIDE).withoutNoise();
            return new MotionTrial(Trial.direct(scene, 0, robot.controller()), robot, idle::add);
        }
        trial.reset(0, robot.controller());
        return new MotionTrial(trial, robot, idle::add);
    }

    /**
     * Creates a trial of a robot of type 0 in its standard stance.
     *
     * @param seed the seed of the disturbances
     * @param newtons force of the pushes
     * @return the trial
     */
    public static MotionTrial inStance(long seed, double newtons) {
        return inStance(RobotType.TYPE_0, WalkStyle.STANDARD, seed, newtons);
    }

    /**
     * Creates a trial of a robot of type 0 that stands in its standard stance at a given pose.
     *
     * @param place the pose
     * @param seed the seed of the disturbances
     * @param newtons force of the pushes
     * @return the trial
     */
    public static MotionTrial inStance(Pose2d place, long seed, double newtons) {
        MotionTrial robot = standing(RobotType.TYPE_0, WalkStyle.STANDARD);
        robot.trial.moveRobot(0, place);
        return robot.intoStance(seed, newtons);
    }

    /**
     * Creates a trial of a robot in its standard stance.
     *
     * @param type the robot type
     * @param style the walk style
     * @param seed the seed of the disturbances
     * @param newtons force of the pushes
     * @return the trial
     */
    public static MotionTrial inStance(RobotType type, WalkStyle style, long seed, double newtons) {
        return standing(type, style).intoStance(seed, newtons);
    }

    /**
     * Creates a trial in a complete simulator, with noise and a referee.
     *
     * @param scene the scene of the robot
     * @param seed the seed of the noise
     * @param robot the controlled robot
     * @return the trial
     */
    public static MotionTrial served(Scene scene, long seed, ScriptedRobot robot) {
        MotionTrial served = new MotionTrial(Trial.served(scene, seed, robot.controller()), robot, Trial::close);
        served.begin(true);
        return served;
    }

    /**
     * Moves the robot to its standard stance via a randomly disturbed posture, begins the measurement, and starts
     * pushing the robot once per second.
     *
     * @param seed the seed of the disturbances
     * @param newtons force of the pushes
     * @return this trial
     */
    public MotionTrial intoStance(long seed, double newtons) {
        Random random = new Random(seed);
        random.nextLong();
        moveTo(nearStance(random), 600);
        moveTo(Stance.POSTURE, 400);
        hold(0.2);
        if (newtons > 0) {
            trial.with(Pushes.equal(random::nextDouble, newtons));
        }
        begin(true);
        return this;
    }

    /** Returns the standard stance with normally distributed offsets added to its joint angles. */
    private static Posture nearStance(Random random) {
        double[] angles = Stance.POSTURE.toArray();
        for (int i = 0; i < angles.length; i++) {
            angles[i] += NOISE_DEGREES * random.nextGaussian();
        }
        return Posture.of(angles).clamped();
    }

    /**
     * Begins a new measurement and removes all measures.
     *
     * @param untilFall whether a fall ends the trial
     */
    public void begin(boolean untilFall) {
        start = trial.now();
        balance = new BalanceMetrics();
        turn = new Turn();
        measures.clear();
        watch(balance);
        watch(turn);
        endsWithFall = untilFall;
    }

    /** Lets the trial continue after a fall. */
    public void allowFalls() {
        endsWithFall = false;
    }

    /**
     * Adds a measure, which receives the current state and the states of all subsequent cycles.
     *
     * @param measure the measure
     */
    public void watch(Measure measure) {
        measure.see(trial.now());
        measures.add(measure);
    }

    /**
     * Plays a motion to its end.
     *
     * @param motion the motion
     * @return whether the trial continues; false if a fall has ended it
     */
    public boolean play(Motion motion) {
        if (!isOver()) {
            robot.play(motion);
        }
        return runWhile(robot::isBusy);
    }

    void moveTo(Posture posture, int millis) {
        play(new Motion("move", List.of(new Keyframe(millis, posture))));
    }

    /**
     * Holds the joints still, for example between two motions.
     *
     * @param seconds the duration
     * @return whether the trial continues; false if a fall has ended it
     */
    public boolean hold(double seconds) {
        double latest = trial.seconds() + seconds - Cycle.SECONDS / 2;
        return runWhile(() -> trial.seconds() < latest);
    }

    /**
     * Walks while a condition holds. The robot keeps walking afterwards until {@link #stopWalking}.
     *
     * @param velocity supplies the velocity for each cycle
     * @param condition evaluated in each cycle
     * @return whether the trial continues; false if a fall has ended it
     */
    public boolean walk(Supplier<WalkVelocity> velocity, BooleanSupplier condition) {
        return runWhile(() -> {
            robot.walk(velocity.get());
            return condition.getAsBoolean();
        });
    }

    /**
     * Stops walking.
     *
     * @return whether the trial continues; false if a fall has ended it
     */
    public boolean stopWalking() {
        robot.walk(WalkVelocity.ZERO);
        double latest = trial.seconds() + MAX_SECONDS_TO_STOP;
        return runWhile(() -> robot.isBusy() && trial.seconds() < latest);
    }

    private boolean runWhile(BooleanSupplier condition) {
        double latest = trial.seconds() + MAX_SECONDS;
        while (!isOver() && trial.seconds() < latest && condition.getAsBoolean()) {
            WorldState moment = trial.step();
            measures.forEach(measure -> measure.see(moment));
        }
        return !isOver();
    }

    private boolean isOver() {
        return endsWithFall && balance.hasFallen();
    }

    /**
     * {@return whether the robot is in its standard stance after holding its joints for 0.6 s; false if a fall has
     * ended the trial; see {@link #isInStance}}
     */
    public boolean endsInStance() {
        return hold(SETTLING_SECONDS) && isInStance();
    }

    /** {@return whether the robot stands upright, at rest and in its standard stance} */
    public boolean isInStance() {
        return isAtRest() && body().joints().largestDifference(Stance.POSTURE) < POSTURE_DEGREES;
    }

    /** {@return whether the robot stands upright and at rest} */
    public boolean isAtRest() {
        return body().isStanding()
                && body().tiltDegrees() < UPRIGHT_DEGREES
                && trial.robot(0).torsoVelocity().length() < REST_METRES_PER_SECOND;
    }

    /** {@return the underlying trial, for access to the robot and the ball} */
    public Trial trial() {
        return trial;
    }

    /** {@return the true state of the robot's body} */
    public BodyState body() {
        return trial.robot(0).body();
    }

    /** {@return the simulated time since the beginning of the measurement, in seconds} */
    public double seconds() {
        return trial.seconds() - start.seconds();
    }

    /** {@return the balance since the beginning of the measurement} */
    public BalanceMetrics balance() {
        return balance;
    }

    /** {@return the displacement along the initial heading, in metres} */
    public double forward() {
        return start.place().ahead(body().position());
    }

    /** {@return the displacement to the left of the initial heading, in metres} */
    public double left() {
        return start.place().left(body().position());
    }

    /** {@return the accumulated rotation in degrees, positive to the left, including full turns} */
    public double turnedDegrees() {
        return turn.value();
    }

    /** {@return the pose at the beginning of the measurement} */
    public Pose2d start() {
        return start.place();
    }

    /**
     * Places the ball at a position with a random offset of up to 1 cm along each axis.
     *
     * @param ball the nominal position relative to the initial pose
     * @param seed the seed of the offset
     */
    public void placeBall(Translation2d ball, long seed) {
        Random random = new Random(7 * seed + 3);
        random.nextLong();
        double ahead = ball.x() + BALL_ERROR_METRES * (2 * random.nextDouble() - 1);
        double left = ball.y() + BALL_ERROR_METRES * (2 * random.nextDouble() - 1);
        trial.placeBall(start().pointAt(ahead, left));
    }

    @Override
    public void close() {
        end.accept(trial);
    }
}
