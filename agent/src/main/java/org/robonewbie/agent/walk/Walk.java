package org.robonewbie.agent.walk;

import java.util.Optional;
import java.util.function.Supplier;
import java.util.stream.Stream;
import org.robonewbie.agent.log.Mistakes;
import org.robonewbie.agent.motion.Motions;
import org.robonewbie.agent.motion.Motors;
import org.robonewbie.agent.motion.PostureFollower;
import org.robonewbie.agent.perception.BodyPosition;
import org.robonewbie.agent.perception.TorsoMotion;
import org.robonewbie.nao.kinematics.Leg;

/**
 * Walks into any direction, faster and more nimbly than a motion of keyframes: forward, aside and turning at the same time.
 *
 * <pre>{@code
 * walk.towards(0.4, 0, ballBearing);    // turns to the ball while it walks
 * if (ballDistance < 0.2) {
 *     motions.start("kick-right");      // the robot first stops walking, then it kicks
 * }
 * }</pre>
 *
 * <p>A velocity holds until another one is given, {@link #stop} is called or a motion is started; while a motion is running the
 * robot does not walk. The robot changes its velocity from step to step, and no step can be broken off, so an answer takes
 * about half a second. A robot that lies on the ground does not walk: {@code motions.startGetUp()} brings it to its feet.
 *
 * <p>How it works: {@link WalkEngine}.
 */
public final class Walk {

    /** The largest speed forward in metres per second; backward it is less. */
    public static final double MOST_FORWARD = WalkStyle.STANDARD.most().forward();

    /** The largest speed aside in metres per second. */
    public static final double MOST_LEFT = WalkStyle.STANDARD.most().left();

    /** The largest speed of turning in degrees per second. */
    public static final double MOST_TURN = WalkStyle.STANDARD.most().turn();

    private static final double NEAR_DEGREES = 8;

    private final Motors motors;
    private final Motions motions;
    private final Mistakes mistakes;
    private final Supplier<BodyPosition> bodyPosition;
    private final WalkEngine engine = new WalkEngine(WalkStyle.STANDARD);
    private final PostureFollower follower;
    private final Pace wanted = new Pace();
    private boolean walking;
    private boolean preparing;

    /**
     * Creates a walk; the framework does this for each robot.
     *
     * @param motors take the speeds
     * @param motions have precedence over walking
     * @param mistakes takes what is wrong with a velocity
     * @param bodyPosition tells whether the robot lies on the ground
     */
    public Walk(Motors motors, Motions motions, Mistakes mistakes, Supplier<BodyPosition> bodyPosition) {
        this.motors = motors;
        this.motions = motions;
        this.mistakes = mistakes;
        this.bodyPosition = bodyPosition;
        this.follower = new PostureFollower(motors);
    }

    /**
     * Walks with a velocity from now on; what is more than the robot can do is slowed down, its direction kept.
     *
     * @param forwardMetresPerSecond up to {@link #MOST_FORWARD}; negative is backward
     * @param leftMetresPerSecond up to {@link #MOST_LEFT}; negative is to the right
     * @param turnDegreesPerSecond up to {@link #MOST_TURN}; positive is to the left, negative to the right
     */
    public void towards(double forwardMetresPerSecond, double leftMetresPerSecond, double turnDegreesPerSecond) {
        if (!Double.isFinite(forwardMetresPerSecond + leftMetresPerSecond + turnDegreesPerSecond)) {
            mistakes.report(
                    "walk NaN",
                    () -> "Walking towards " + forwardMetresPerSecond + ", " + leftMetresPerSecond + ", "
                            + turnDegreesPerSecond + " is ignored. Was something divided by zero?");
            return;
        }
        wanted.set(forwardMetresPerSecond, leftMetresPerSecond, turnDegreesPerSecond);
    }

    /** Stops with both feet side by side; that takes up to a second. */
    public void stop() {
        wanted.set(0, 0, 0);
    }

    /**
     * Tells whether the robot walks or has not yet come to a stand.
     *
     * @return whether its feet are moving
     */
    public boolean isWalking() {
        return walking;
    }

    /**
     * Names what the robot does.
     *
     * @return {@code walk} while its feet are moving, or the name of the running motion; empty if it does neither
     */
    public Optional<String> current() {
        return walking ? Optional.of("walk") : motions.current();
    }

    /**
     * Tells which keyframe of the running motion the robot approaches.
     *
     * @return its number from 1; 0 if it walks or no motion is running
     */
    public int keyframe() {
        return walking ? 0 : motions.keyframe();
    }

    /** The robot was put somewhere else: it stands. */
    public void reset() {
        wanted.set(0, 0, 0);
        walking = false;
        preparing = false;
        engine.reset();
    }

    /**
     * Plays one cycle of walking, or of a motion; the framework does this when the robot acts.
     *
     * @param torso what gyroscope and accelerometer feel
     */
    public void update(TorsoMotion torso) {
        engine.feel(torso);
        if (!motions.isFinished() && !preparing) {
            wanted.set(0, 0, 0);
        }
        if (bodyPosition.get().isFallen()) {
            reset();
        }
        if (!walking && !wanted.isZero() && motions.isFinished()) {
            start();
        }
        if (walking) {
            step();
        } else {
            motions.update();
        }
    }

    /** Begins in the stance; from elsewhere the robot goes there first. */
    private void start() {
        preparing = !preparing && !isNearStance() && motions.start("stand");
        if (!preparing) {
            walking = true;
            follower.begin();
        }
    }

    private void step() {
        engine.towards(wanted.forward(), wanted.left(), wanted.turn());
        follower.follow(engine.next());
        walking = !engine.isStanding();
    }

    private boolean isNearStance() {
        return Stream.of(Leg.values())
                .flatMap(leg -> leg.joints().stream())
                .allMatch(joint -> Math.abs(motors.degrees(joint) - Stance.POSTURE.degrees(joint)) < NEAR_DEGREES);
    }
}
