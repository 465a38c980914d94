package org.robonewbie.agent.walk;

import java.util.Optional;
import java.util.function.Supplier;
import java.util.stream.Stream;
import org.robonewbie.agent.log.Diagnostics;
import org.robonewbie.agent.motion.MotionSequencer;
import org.robonewbie.agent.perception.BodyPosition;
import org.robonewbie.agent.perception.FootPressure;
import org.robonewbie.agent.perception.TorsoMotion;
import org.robonewbie.nao.kinematics.Leg;
import org.robonewbie.nao.motion.Motors;
import org.robonewbie.nao.motion.PostureFollower;

/** Drives the joints: the walk engine while the robot walks, its motions otherwise. */
public final class WalkController implements Walk {

    private static final double NEAR_DEGREES = 8;
    private static final PolicyWalk STANDARD = new PolicyWalk(WalkStyle.STANDARD, WalkReflex.NONE);

    private final Motors motors;
    private final MotionSequencer motions;
    private final Diagnostics diagnostics;
    private final Supplier<BodyPosition> bodyPosition;
    private WalkEngine engine = new WalkEngine(WalkStyle.STANDARD);
    private PolicyWalk manner = STANDARD;
    private PolicyWalk walked = STANDARD;
    private final PostureFollower follower;
    private WalkVelocity wanted = WalkVelocity.ZERO;
    private boolean walking;
    private boolean preparing;

    /**
     * Creates a walk at rest.
     *
     * @param motors receive the speeds
     * @param motions have precedence over walking
     * @param diagnostics reports what is wrong with a velocity
     * @param bodyPosition whether the robot lies on the ground
     */
    public WalkController(
            Motors motors, MotionSequencer motions, Diagnostics diagnostics, Supplier<BodyPosition> bodyPosition) {
        this.motors = motors;
        this.motions = motions;
        this.diagnostics = diagnostics;
        this.bodyPosition = bodyPosition;
        this.follower = new PostureFollower(motors);
    }

    @Override
    public void towards(double forwardMetresPerSecond, double leftMetresPerSecond, double turnDegreesPerSecond) {
        if (!Double.isFinite(forwardMetresPerSecond + leftMetresPerSecond + turnDegreesPerSecond)) {
            diagnostics.report(
                    "walk NaN",
                    () -> "Walking towards " + forwardMetresPerSecond + ", " + leftMetresPerSecond + ", "
                            + turnDegreesPerSecond + " is ignored. Was something divided by zero?");
            return;
        }
        wanted = new WalkVelocity(forwardMetresPerSecond, leftMetresPerSecond, turnDegreesPerSecond);
    }

    @Override
    public void stop() {
        wanted = WalkVelocity.ZERO;
    }

    @Override
    public void setStyle(WalkStyle style) {
        manner = new PolicyWalk(style, WalkReflex.NONE);
    }

    @Override
    public void setPolicy(PolicyWalk policy) {
        manner = policy;
    }

    @Override
    public boolean isWalking() {
        return walking;
    }

    /** {@return {@code walk} while the feet are moving, or the name of the running motion; empty if there is neither} */
    public Optional<String> current() {
        return walking ? Optional.of("walk") : motions.current();
    }

    /** {@return the number of the running motion's keyframe, from 1; 0 if the robot walks or no motion is running} */
    public int keyframe() {
        return walking ? 0 : motions.keyframe();
    }

    /** Forgets all steps, since the robot was put somewhere else and stands there. */
    public void reset() {
        wanted = WalkVelocity.ZERO;
        walking = false;
        preparing = false;
        engine.reset();
    }

    /**
     * Plays one cycle of walking, or of a motion, without feeling the soles.
     *
     * @param torso what gyroscope and accelerometer feel
     */
    public void update(TorsoMotion torso) {
        update(torso, FootPressure.NONE, FootPressure.NONE);
    }

    /**
     * Plays one cycle of walking, or of a motion.
     *
     * @param torso what gyroscope and accelerometer feel
     * @param leftFoot what the left sole feels
     * @param rightFoot what the right sole feels
     */
    public void update(TorsoMotion torso, FootPressure leftFoot, FootPressure rightFoot) {
        engine.update(torso);
        engine.update(leftFoot, rightFoot);
        if (!motions.isFinished() && !preparing) {
            wanted = WalkVelocity.ZERO;
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
            changeManner();
            follower.begin();
        }
    }

    /** A new engine has felt nothing yet, so the old one stays while the manner is the same. */
    private void changeManner() {
        if (!manner.equals(walked)) {
            engine = new WalkEngine(manner.style(), manner.reflex());
            walked = manner;
        }
    }

    private void step() {
        engine.towards(wanted);
        follower.follow(engine.next());
        walking = !engine.isStanding();
    }

    private boolean isNearStance() {
        return Stream.of(Leg.values())
                .flatMap(leg -> leg.joints().stream())
                .allMatch(joint ->
                        Math.abs(motors.joints().degrees(joint) - Stance.POSTURE.degrees(joint)) < NEAR_DEGREES);
    }
}
