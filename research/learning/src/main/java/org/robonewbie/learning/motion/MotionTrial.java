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
import org.robonewbie.trial.measure.Turn;

/**
 * A trial in which a robot plays one motion after the other, or walks, as a script says step by step. All is measured from where the
 * robot was when the trial began. A robot that begins on its feet does nothing more once it has fallen.
 *
 * <pre>{@code
 * try (MotionTrial trial = MotionTrial.inStance(seed, 3)) {
 *     trial.play(walk);
 *     boolean good = trial.play(stop) && trial.endsInStance();
 * }
 * }</pre>
 */
public final class MotionTrial implements AutoCloseable {

    /** A standard robot at the place where motions are tried on the beginners' pitch. */
    public static final RobotStart ROBOT = RobotStart.at(-4.5, 1.5);

    /** A place for the ball where it does not disturb. */
    public static final Vector3 BALL_ASIDE = new Vector3(0, -3.5, 0);

    private static final double NOISE_DEGREES = 1;
    private static final double BALL_ERROR_METRES = 0.01;
    private static final double SETTLING_SECONDS = 0.6;
    private static final double MAX_SECONDS_TO_STOP = 3;
    private static final double MAX_SECONDS = 60;
    private static final double POSTURE_DEGREES = 3;
    private static final double UPRIGHT_DEGREES = 12;
    private static final double REST_METRES_PER_SECOND = 0.05;

    /** Direct trials of each robot type that are not in use: resetting one is much faster than beginning another. */
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

    /** Begins with a robot that stands with all joints at 0, without noise and without referee. */
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
     * Begins with a standard robot in the stance, reached by way of a nearby posture.
     *
     * @param seed chooses the disturbances
     * @param newtons strength of the pushes
     * @return the robot on its feet
     */
    public static MotionTrial inStance(long seed, double newtons) {
        return inStance(RobotType.TYPE_0, WalkStyle.STANDARD, seed, newtons);
    }

    /**
     * Begins with a standard robot in the stance somewhere else.
     *
     * @param place where it stands
     * @param seed chooses the disturbances
     * @param newtons strength of the pushes
     * @return the robot on its feet
     */
    public static MotionTrial inStance(Pose2d place, long seed, double newtons) {
        MotionTrial begun = standing(RobotType.TYPE_0, WalkStyle.STANDARD);
        begun.trial.moveRobot(0, place);
        return begun.intoStance(seed, newtons);
    }

    /**
     * Begins with a robot of some build in the stance.
     *
     * @param type how it is built
     * @param style how it walks
     * @param seed chooses the disturbances
     * @param newtons strength of the pushes
     * @return the robot on its feet
     */
    public static MotionTrial inStance(RobotType type, WalkStyle style, long seed, double newtons) {
        return standing(type, style).intoStance(seed, newtons);
    }

    /**
     * Begins on a whole simulator, with noise and a referee.
     *
     * @param scene where the robot stands
     * @param seed chooses the noise
     * @param robot controls it
     * @return the trial at its beginning
     */
    public static MotionTrial served(Scene scene, long seed, ScriptedRobot robot) {
        MotionTrial begun = new MotionTrial(Trial.served(scene, seed, robot.controller()), robot, Trial::close);
        begun.begin(true);
        return begun;
    }

    /**
     * Goes into the stance by way of a nearby posture, begins to measure there, and is pushed once a second from then on.
     *
     * @param seed chooses the disturbances
     * @param newtons strength of the pushes
     * @return this trial
     */
    public MotionTrial intoStance(long seed, double newtons) {
        Disturbance disturbance = new Disturbance(seed, newtons);
        moveTo(disturbance.near(Stance.POSTURE, NOISE_DEGREES), 600);
        moveTo(Stance.POSTURE, 400);
        hold(0.2);
        trial.with(disturbance);
        begin(true);
        return this;
    }

    /**
     * Measures from now on, as if nothing had been before.
     *
     * @param untilFall whether the robot does nothing more once it has fallen
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

    /** Lets the robot go on after a fall. */
    public void allowFalls() {
        endsWithFall = false;
    }

    /**
     * Shows each cycle from now on to a measure.
     *
     * @param measure sees the present moment first
     */
    public void watch(Measure measure) {
        measure.see(trial.now());
        measures.add(measure);
    }

    /**
     * Plays a motion to its end.
     *
     * @param motion the motion
     * @return whether no fall broke it off
     */
    public boolean play(Motion motion) {
        if (!isOver()) {
            robot.play(motion);
        }
        return runWhile(robot::isBusy);
    }

    /** Moves to a posture. */
    void moveTo(Posture posture, int millis) {
        play(new Motion("move", List.of(new Keyframe(millis, posture))));
    }

    /**
     * Waits with motors that hold their joints, as between two motions.
     *
     * @param seconds how long
     * @return whether no fall broke it off
     */
    public boolean hold(double seconds) {
        double latest = trial.seconds() + seconds - Cycle.SECONDS / 2;
        return runWhile(() -> trial.seconds() < latest);
    }

    /**
     * Walks for a while; the robot goes on walking until {@link #stopWalking}.
     *
     * @param velocity asked in each cycle for where to
     * @param condition asked in each cycle whether to go on
     * @return whether no fall broke it off
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
     * @return whether no fall broke it off
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

    /** {@return whether the robot has kept on its feet and, a moment later, stands upright, at rest and in the stance} */
    public boolean endsInStance() {
        return hold(SETTLING_SECONDS) && isInStance();
    }

    /** {@return whether the robot stands upright, at rest and in the stance} */
    public boolean isInStance() {
        return isAtRest() && body().joints().largestDifference(Stance.POSTURE) < POSTURE_DEGREES;
    }

    /** {@return whether the robot stands upright and at rest} */
    public boolean isAtRest() {
        return body().isStanding()
                && body().tiltDegrees() < UPRIGHT_DEGREES
                && trial.robot(0).torsoVelocity().length() < REST_METRES_PER_SECOND;
    }

    /** {@return the trial in which all this happens, to look at robot and ball or to push them} */
    public Trial trial() {
        return trial;
    }

    /** {@return the true state of the robot's body} */
    public BodyState body() {
        return trial.robot(0).body();
    }

    /** {@return seconds since the beginning} */
    public double seconds() {
        return trial.seconds() - start.seconds();
    }

    /** {@return how steady the robot has been since the beginning} */
    public BalanceMetrics balance() {
        return balance;
    }

    /** {@return metres that the robot has moved along its first heading} */
    public double forward() {
        return start.place().ahead(body().position());
    }

    /** {@return metres that the robot has moved to the left of its first heading} */
    public double left() {
        return start.place().left(body().position());
    }

    /** {@return degrees that the robot has turned, positive to the left, whole turns included} */
    public double turnedDegrees() {
        return turn.value();
    }

    /** {@return where the robot stood at first} */
    public Pose2d start() {
        return start.place();
    }

    /**
     * Places the ball before the robot, up to 1 cm away from its place along each axis.
     *
     * @param ball its nominal place as seen from where the robot stood at first
     * @param seed chooses how far away
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
