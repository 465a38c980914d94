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

/** Controls the joints, with the walk engine while the robot is walking and with motions otherwise. */
public final class WalkController implements Walk {

    private static final double NEAR_DEGREES = 8;
    private static final PolicyWalk STANDARD = new PolicyWalk(WalkStyle.STANDARD, WalkReflex.NONE);

    private final Motors motors;
    private final MotionSequencer motions;
    private final Diagnostics diagnostics;
    private final Supplier<BodyPosition> bodyPosition;
    private WalkEngine engine = new WalkEngine(WalkStyle.STANDARD);
    private PolicyWalk selected = STANDARD;
    private PolicyWalk active = STANDARD;
    private final PostureFollower follower;
    private WalkVelocity wanted = WalkVelocity.ZERO;
    private boolean walking;
    private boolean preparing;
    private Optional<Locomotion> locomotion = Optional.empty();

    /**
     * Creates a controller for a robot at rest.
     *
     * @param motors motors that receive the joint targets
     * @param motions keyframe motions, which take precedence over walking
     * @param diagnostics receives reports about invalid velocities
     * @param bodyPosition supplies the orientation of the torso
     */
    public WalkController(
            Motors motors, MotionSequencer motions, Diagnostics diagnostics, Supplier<BodyPosition> bodyPosition) {
        this.motors = motors;
        this.motions = motions;
        this.diagnostics = diagnostics;
        this.bodyPosition = bodyPosition;
        this.follower = new PostureFollower(motors);
    }

    /**
     * Lets another robot than the NAO walk.
     *
     * @param own walks instead of the walk engine
     */
    public void setLocomotion(Locomotion own) {
        locomotion = Optional.of(own);
    }

    @Override
    public void towards(double forwardMetresPerSecond, double leftMetresPerSecond, double turnDegreesPerSecond) {
        if (!Double.isFinite(forwardMetresPerSecond + leftMetresPerSecond + turnDegreesPerSecond)) {
            diagnostics.report(
                    "walk NaN",
                    () -> "The walk command " + forwardMetresPerSecond + ", " + leftMetresPerSecond + ", "
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
        selected = new PolicyWalk(style, WalkReflex.NONE);
    }

    @Override
    public void setPolicy(PolicyWalk policy) {
        selected = policy;
    }

    @Override
    public boolean isWalking() {
        return walking;
    }

    /** {@return {@code walk} while the robot is walking, otherwise the name of the running motion, if any} */
    public Optional<String> current() {
        return walking ? Optional.of("walk") : motions.current();
    }

    /**
     * {@return the one-based number of the running motion's current keyframe; 0 if the robot is walking or no motion is
     * running}
     */
    public int keyframe() {
        return walking ? 0 : motions.keyframe();
    }

    /** Resets the walk after the robot has been placed upright at another position. */
    public void reset() {
        wanted = WalkVelocity.ZERO;
        walking = false;
        preparing = false;
        engine.reset();
    }

    /**
     * Plays one cycle of walking or of a motion.
     *
     * @param torso readings of the gyroscope and the accelerometer
     * @param leftFoot force on the left sole
     * @param rightFoot force on the right sole
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
        if (locomotion.isPresent()) {
            locomotion.get().towards(wanted);
            walking = locomotion.get().isWalking();
            motions.update();
            return;
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

    /**
     * Starts walking if the posture is close to {@link Stance}; otherwise the robot first plays the motion {@code
     * stand}.
     */
    private void start() {
        preparing = !preparing && !isNearStance() && motions.start("stand");
        if (!preparing) {
            walking = true;
            updateEngine();
            follower.begin();
        }
    }

    /** Replaces the engine if the style has changed; otherwise keeps it, along with its tilt estimate. */
    private void updateEngine() {
        if (!selected.equals(active)) {
            engine = new WalkEngine(selected.style(), selected.reflex());
            active = selected;
        }
    }

    private void step() {
        if (!selected.equals(active)) {
            engine.change(selected);
            active = selected;
        }
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
