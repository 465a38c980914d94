package org.robonewbie.learning.rehearsal;

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
import org.robonewbie.nao.kinematics.BodyState;
import org.robonewbie.nao.kinematics.Pose;
import org.robonewbie.nao.model.NaoModel;
import org.robonewbie.nao.model.RobotType;
import org.robonewbie.nao.motion.BallPlace;
import org.robonewbie.nao.motion.Keyframe;
import org.robonewbie.nao.motion.Motion;
import org.robonewbie.nao.motion.Posture;
import org.robonewbie.simulator.world.Robot;
import org.robonewbie.trial.Measure;
import org.robonewbie.trial.RobotStart;
import org.robonewbie.trial.Scene;
import org.robonewbie.trial.Trial;
import org.robonewbie.trial.TrialHook;
import org.robonewbie.trial.WorldState;
import org.robonewbie.trial.measure.Turn;

/**
 * A trial in which a robot plays one motion after the other, or walks, as it is told step by step. What it does is measured from
 * where it was at first. A robot that begins on its feet does nothing more once it has fallen.
 *
 * <pre>{@code
 * try (Rehearsal rehearsal = Rehearsal.inStance(seed, 3)) {
 *     rehearsal.play(walk);
 *     boolean good = rehearsal.play(stop) && rehearsal.endsInStance();
 * }
 * }</pre>
 */
public final class Rehearsal implements AutoCloseable {

    private static final Pose2d START = new Pose2d(-4.5, 1.5, 0);
    private static final RobotStart ROBOT = RobotStart.at(START);
    private static final Vector3 BALL_ASIDE = new Vector3(0, -3.5, 0);
    private static final double NOISE_DEGREES = 1;
    private static final double SETTLING_SECONDS = 0.6;
    private static final double SECONDS_TO_STOP = 3;
    private static final double MOST_SECONDS = 60;
    private static final double POSTURE_DEGREES = 3;
    private static final double UPRIGHT_DEGREES = 12;
    private static final double REST_METRES_PER_SECOND = 0.05;

    /** Direct trials of each robot type that are not in use: resetting one is much faster than beginning another. */
    private static final Map<RobotType, Queue<Trial>> IDLE = new ConcurrentHashMap<>();

    private final Trial trial;
    private final Puppet puppet;
    private final Consumer<Trial> end;
    private final List<Measure> guests = new ArrayList<>();
    private WorldState start;
    private Poise poise;
    private Turn turn = new Turn();
    private boolean endsWithFall;

    private Rehearsal(Trial trial, Puppet puppet, Consumer<Trial> end) {
        this.trial = trial;
        this.puppet = puppet;
        this.end = end;
        this.start = trial.now();
        this.poise = new Poise(start.robot());
    }

    /** A robot without noise that stands with all joints at 0. */
    static Rehearsal standing(RobotType type, WalkStyle style) {
        MotorPuppet puppet = new MotorPuppet(new PolicyWalk(style, WalkReflex.NONE));
        Queue<Trial> idle = IDLE.computeIfAbsent(type, key -> new ConcurrentLinkedQueue<>());
        Trial trial = idle.poll();
        if (trial == null) {
            Scene scene = Scene.of(ROBOT.withType(type)).withBall(BALL_ASIDE).withoutNoise();
            return new Rehearsal(Trial.direct(scene, 0, puppet.controller()), puppet, idle::add);
        }
        trial.reset(0, puppet.controller());
        return new Rehearsal(trial, puppet, idle::add);
    }

    /** Makes the present moment the one to which {@link #again} returns. The robot must rest, and this rehearsal stays open. */
    void keep() {
        trial.keep();
    }

    /** Returns to the moment that was kept, with motors that hold their joints, and with friction and mass times these factors. */
    Rehearsal again(double grip, double mass) {
        MotorPuppet rested = new MotorPuppet(new PolicyWalk(WalkStyle.STANDARD, WalkReflex.NONE));
        trial.reset(0, rested.controller());
        trial.setGrip(grip);
        trial.robot(0).setMassFactor(mass);
        return new Rehearsal(trial, rested, kept -> {});
    }

    /**
     * Brings a standard robot into the stance by way of a nearby posture.
     *
     * @param seed chooses the disturbances
     * @param newtons strength of the pushes
     * @return the robot on its feet
     */
    public static Rehearsal inStance(long seed, double newtons) {
        return inStance(RobotType.TYPE_0, seed, newtons);
    }

    /**
     * Brings a robot into the stance by way of a nearby posture.
     *
     * @param place where it stands
     * @param seed chooses the disturbances
     * @param newtons strength of the pushes
     * @return the robot on its feet
     */
    public static Rehearsal inStance(Pose2d place, long seed, double newtons) {
        Rehearsal rehearsal = standing(RobotType.TYPE_0, WalkStyle.STANDARD);
        rehearsal.trial.moveRobot(0, place);
        return rehearsal.intoStance(seed, newtons);
    }

    /**
     * Brings a robot with a walk of its own into the stance by way of a nearby posture.
     *
     * @param style how it walks
     * @param seed chooses the disturbances
     * @param newtons strength of the pushes
     * @return the robot on its feet
     */
    public static Rehearsal inStance(WalkStyle style, long seed, double newtons) {
        return standing(RobotType.TYPE_0, style).intoStance(seed, newtons);
    }

    /**
     * Brings a robot of some build into the stance by way of a nearby posture.
     *
     * @param type how it is built
     * @param seed chooses the disturbances
     * @param newtons strength of the pushes
     * @return the robot on its feet
     */
    public static Rehearsal inStance(RobotType type, long seed, double newtons) {
        return standing(type, WalkStyle.STANDARD).intoStance(seed, newtons);
    }

    Rehearsal intoStance(long seed, double newtons) {
        Disturbance disturbance = new Disturbance(seed, newtons);
        moveTo(disturbance.near(Stance.POSTURE, NOISE_DEGREES), 600);
        moveTo(Stance.POSTURE, 400);
        hold(0.2);
        with(disturbance);
        begin(true);
        return this;
    }

    /**
     * Lets an agent in the stance do what it is told, on a whole simulator with noise and a referee.
     *
     * @param seed chooses the noise
     * @param type how the robot is built
     * @return the robot on its feet
     */
    public static Rehearsal served(long seed, RobotType type) {
        Scene scene = Scene.of(ROBOT.withType(type).after("stand")).withBall(BALL_ASIDE);
        return served(scene, seed, new AgentPuppet(WalkStyle.STANDARD));
    }

    /** Lets an agent do what it is told, on a whole simulator with noise and a referee. */
    static Rehearsal served(Scene scene, long seed, Puppet puppet) {
        Rehearsal rehearsal = new Rehearsal(Trial.served(scene, seed, puppet.controller()), puppet, Trial::close);
        rehearsal.begin(true);
        return rehearsal;
    }

    /**
     * Measures from now on, as if nothing had been before.
     *
     * @param untilFall whether the robot does nothing more once it has fallen
     */
    public void begin(boolean untilFall) {
        start = trial.now();
        poise = new Poise(start.robot());
        turn = new Turn();
        turn.see(start);
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
        guests.add(measure);
    }

    /**
     * Adds a hook for what happens to the robot, instead of the one before.
     *
     * @param hook acts after each cycle from now on
     */
    public void with(TrialHook hook) {
        trial.with(hook);
    }

    /**
     * Plays a motion to its end.
     *
     * @param motion the motion
     * @return whether no fall broke it off
     */
    public boolean play(Motion motion) {
        if (!isOver()) {
            puppet.play(motion);
        }
        return runWhile(puppet::isBusy);
    }

    /**
     * Moves to a posture.
     *
     * @param posture where to go
     * @param millis how long it takes
     * @return whether no fall broke it off
     */
    public boolean moveTo(Posture posture, int millis) {
        return play(new Motion("move", List.of(new Keyframe(millis, posture))));
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
     * @param goOn asked in each cycle whether to go on
     * @return whether no fall broke it off
     */
    public boolean walk(Supplier<WalkVelocity> velocity, BooleanSupplier goOn) {
        return runWhile(() -> {
            puppet.walk(velocity.get());
            return goOn.getAsBoolean();
        });
    }

    /**
     * Stops walking.
     *
     * @return whether no fall broke it off
     */
    public boolean stopWalking() {
        puppet.walk(WalkVelocity.ZERO);
        double latest = trial.seconds() + SECONDS_TO_STOP;
        return runWhile(() -> puppet.isBusy() && trial.seconds() < latest);
    }

    private boolean runWhile(BooleanSupplier goOn) {
        double latest = trial.seconds() + MOST_SECONDS;
        while (!isOver() && trial.seconds() < latest && goOn.getAsBoolean()) {
            WorldState state = trial.step();
            poise.see(state);
            turn.see(state);
            guests.forEach(guest -> guest.see(state));
        }
        return !isOver();
    }

    private boolean isOver() {
        return endsWithFall && poise.hasFallen();
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

    /** {@return what is true now} */
    public WorldState now() {
        return trial.now();
    }

    /** {@return the true state of the robot's body} */
    public BodyState body() {
        return trial.robot(0).body();
    }

    /**
     * Returns where a link of the robot really is. A limb that swings fast is pulled out of its joints for some cycles, by up to a few
     * centimetres; the kinematics of {@link #body} do not know that.
     *
     * @param name the link's name in {@link NaoModel}, such as {@code rfoot}
     * @return its centre and orientation in the world frame
     */
    public Pose link(String name) {
        Robot robot = trial.robot(0);
        return robot.linkPose(robot.model().linkIndex(name)).toBodyAxes();
    }

    /** {@return seconds since the beginning} */
    public double seconds() {
        return trial.seconds() - start.seconds();
    }

    /** {@return how steady the robot has been since the beginning} */
    public Poise poise() {
        return poise;
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
    public void placeBall(BallPlace ball, long seed) {
        Random random = new Random(7 * seed + 3);
        random.nextLong();
        BallPlace near = ball.near(random);
        trial.placeBall(start().pointAt(near.ahead(), near.left()));
    }

    /**
     * Shoots the ball.
     *
     * @param from where it lies at first; its height does not matter
     * @param metresPerSecond its velocity
     */
    public void shoot(Vector3 from, Vector3 metresPerSecond) {
        trial.placeBall(from);
        trial.ball().setVelocity(metresPerSecond);
    }

    @Override
    public void close() {
        end.accept(trial);
    }
}
