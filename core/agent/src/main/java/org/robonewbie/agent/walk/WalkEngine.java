package org.robonewbie.agent.walk;

import org.robonewbie.agent.perception.FootPressure;
import org.robonewbie.agent.perception.TorsoMotion;
import org.robonewbie.nao.geometry.Pose2d;
import org.robonewbie.nao.kinematics.InverseKinematics;
import org.robonewbie.nao.kinematics.Leg;
import org.robonewbie.nao.model.RobotType;
import org.robonewbie.nao.motion.Posture;

/**
 * Walk engine: converts a velocity into one posture for each cycle. It is a pure computation that needs no connection
 * to a simulator.
 *
 * <p><img src="doc-files/step.svg" alt="A step seen from above: support foot, swing foot and the path of the torso between
 * them; below it the curves of lift, travel and sway over the step phase">
 *
 * <p><b>Planning.</b> Steps are planned one at a time. At the beginning of a step the velocity v = (vx, vy, ω) approaches the
 * requested one with limited acceleration. With the step duration T and half the distance between the feet w, the target of the
 * swing foot, relative to the support foot, is
 *
 * <pre>
 * ahead  = slip · vx · T
 * aside  = 2w + max(0, ± 2 slip · vy · T)      + if the left foot swings, − if the right one does
 * turned = max(0, ± 2 slip · ω · T)
 * </pre>
 *
 * <p>so that the midpoint between the feet moves with the velocity v. When the robot walks sideways or turns, the leg
 * on the side of the movement steps outward (by twice the distance per step, because it does so only in every other
 * step), and the other leg follows in the next step.
 *
 * <p><b>Motion.</b> In each cycle the step phase φ = t / T determines the positions of the feet and the torso:
 * {@link Step}, with the trajectories of {@link StepPhase}. Inverse kinematics yields the joint angles of the legs.
 * This is an open-loop gait: the plan is a fixed function of the phase, and does not depend on the robot's mass.
 *
 * <p><b>Balance.</b> {@link Balance} estimates the tilt of the torso; {@link BalanceGains} converts its deviation from
 * the plan into corrections to the ankles, the hips and the target of the swing foot.
 *
 * <p>The walk begins and ends with a step in place whose amplitude a rises from 0 to 1 or falls back to 0; the posture
 * is (1 − s) · {@link Stance} + s · step with s = a²(3 − 2a).
 *
 * <p>Sources: S. Behnke, <em>Online trajectory generation for omnidirectional biped walking</em>, ICRA 2006 (sway, lift and
 * swing as functions of a gait phase; step lengths from velocities); F. Faber and S. Behnke, <em>Stochastic optimization of
 * bipedal walking using gyro feedback and phase resetting</em>, Humanoids 2007 (feedback from a gyroscope, parameters found by
 * a search). This engine does not plan the zero moment point; for walks that do, see S. Kajita et al., <em>Biped walking
 * pattern generation by using preview control of zero-moment point</em>, ICRA 2003.
 */
public final class WalkEngine {

    private static final int CYCLE_MILLIS = 20;

    /** Minimum duration of the last step in cycles, for styles with very short steps. */
    private static final int MIN_CYCLES_OF_LAST_STEP = 10;

    /** Excess of the forward speed, in metres per second, that is small enough for a change to a slower walk. */
    private static final double SLOW_ENOUGH = 0.02;

    private PolicyWalk walk;
    private PolicyWalk nextWalk;
    private WalkReflex reflex;
    private final InverseKinematics kinematics = new InverseKinematics(RobotType.TYPE_0);
    private final Balance balance = new Balance();
    private int cyclesPerStep;
    private WalkVelocity wanted = WalkVelocity.ZERO;
    private WalkVelocity velocity = WalkVelocity.ZERO;
    private Pose2d left = Stance.LEFT_FOOT;
    private Pose2d right = Stance.RIGHT_FOOT;
    private Leg swing = Leg.LEFT;
    private TorsoPosture torso;
    private Step step;
    private Posture walking = Stance.POSTURE;
    private boolean standing = true;
    private boolean feetSideBySide = true;
    private int cycle;
    private FootPressure leftSole = FootPressure.NONE;
    private FootPressure rightSole = FootPressure.NONE;

    /**
     * Creates an engine without a reflex.
     *
     * @param style parameters of the walk
     */
    public WalkEngine(WalkStyle style) {
        this(style, WalkReflex.NONE);
    }

    /**
     * Creates an engine with a reflex.
     *
     * @param style parameters of the walk
     * @param reflex corrects each posture
     */
    public WalkEngine(WalkStyle style, WalkReflex reflex) {
        this.reflex = reflex.forEngine();
        this.walk = new PolicyWalk(style, reflex);
        this.nextWalk = walk;
        this.torso = TorsoPosture.of(style.gait(), 0);
        this.step = stepTo(left, torso);
    }

    /**
     * Sets the requested velocity.
     *
     * @param newVelocity the velocity; it is scaled down to the limits of the style
     */
    public void towards(WalkVelocity newVelocity) {
        WalkStyle next = nextWalk.style();
        wanted = newVelocity.within(style().most(), style().backward()).within(next.most(), next.backward());
    }

    /**
     * Sets the walk for the next steps. While the robot is faster than that walk allows, it slows down with the current one
     * first.
     *
     * @param newWalk parameters and reflex
     */
    public void change(PolicyWalk newWalk) {
        nextWalk = newWalk;
    }

    /** {@return whether the robot is standing in the posture {@link Stance} and the requested velocity is zero} */
    public boolean isStanding() {
        return standing && wanted.isZero();
    }

    /** Resets the engine to the posture {@link Stance}. */
    public void reset() {
        standing = true;
        feetSideBySide = true;
        wanted = WalkVelocity.ZERO;
        velocity = WalkVelocity.ZERO;
        torso = TorsoPosture.of(style().gait(), 0);
        putFeetSideBySide();
        cycle = 0;
        balance.reset();
    }

    /**
     * Updates the tilt estimate. Call this method in each cycle before {@link #next}.
     *
     * @param motion readings of the gyroscope and the accelerometer
     */
    public void update(TorsoMotion motion) {
        balance.update(motion);
    }

    /**
     * Sets the forces on the soles, which only a reflex uses.
     *
     * @param left force on the left sole
     * @param right force on the right sole
     */
    public void update(FootPressure left, FootPressure right) {
        leftSole = left;
        rightSole = right;
    }

    /**
     * Advances by one cycle of 20 ms.
     *
     * @return the posture at the end of the cycle
     */
    public Posture next() {
        if (isStanding()) {
            return Stance.POSTURE;
        }
        if (cycle == 0) {
            step = plan();
        }
        cycle++;
        StepPhase moment = step.at((double) cycle / cyclesPerStep);
        WalkMoment state = state(moment);
        Correction correction = style().gains().correction(state);
        walking = step.posture(kinematics, walking, moment, correction);
        if (cycle == cyclesPerStep) {
            setDown(step.swingFoot(moment, correction));
        }
        return reflex.corrected(
                Stance.POSTURE.towards(walking, smooth(moment.torso().amplitude())), state);
    }

    private WalkMoment state(StepPhase moment) {
        return new WalkMoment(
                swing,
                moment.phase(),
                moment.torso().amplitude(),
                wanted,
                velocity,
                balance.pitchDegrees() - moment.torso().leanDegrees(),
                balance.pitchRate(),
                balance.rollDegrees() - moment.rollDegrees(),
                balance.rollRate(),
                balance.turnRate(),
                leftSole,
                rightSole);
    }

    private Step plan() {
        if (!nextWalk.equals(walk) && isSlowEnoughFor(nextWalk.style())) {
            walk = nextWalk;
            reflex = nextWalk.reflex().forEngine();
        }
        if (standing) {
            walking = Stance.POSTURE;
            swing = wanted.left() + 0.01 * wanted.turn() >= 0 ? Leg.LEFT : Leg.RIGHT;
        }
        boolean stopping = !standing && wanted.isZero() && velocity.isZero() && feetSideBySide;
        WalkVelocity before = velocity;
        velocity = standing ? WalkVelocity.ZERO : velocity.towards(wanted, style().change());
        feetSideBySide = velocity.isZero();
        cyclesPerStep = cyclesOfStep(stopping);
        return stepTo(target(), torsoAtEnd(stopping, velocity.forward() - before.forward()));
    }

    private WalkStyle style() {
        return walk.style();
    }

    private boolean isSlowEnoughFor(WalkStyle next) {
        double most = velocity.within(next.most(), next.backward()).forward();
        return velocity.forward() < most + SLOW_ENOUGH;
    }

    private int cyclesOfStep(boolean stopping) {
        int normal = style().gait().stepMillis() / CYCLE_MILLIS;
        return stopping ? Math.max(normal, MIN_CYCLES_OF_LAST_STEP) : normal;
    }

    private Step stepTo(Pose2d target, TorsoPosture after) {
        return new Step(style().gait(), swing, foot(swing), target, foot(swing.other()), torso, after);
    }

    private TorsoPosture torsoAtEnd(boolean stopping, double change) {
        double lean = style().gait().leanDegrees()
                + style().leanPerSpeed() * velocity.forward()
                + style().leanPerChange() * change;
        double ankleOffset = style().gait().ankleOffset() + style().ankleOffsetPerSpeed() * velocity.forward();
        return new TorsoPosture(stopping ? 0 : 1, lean, ankleOffset);
    }

    /**
     * Returns the target of the swing foot, by moving from the support foot to the path of the torso, along this path, and out
     * to the side of the swing foot.
     */
    private Pose2d target() {
        double seconds = style().gait().stepMillis() / 1000.0;
        WalkVelocity slip = style().slip();
        double side = swing == Leg.LEFT ? 1 : -1;
        double open = Math.max(0, 2 * side * slip.left() * velocity.left() * seconds);
        double twist = Math.max(0, 2 * side * slip.turn() * velocity.turn() * seconds);
        return foot(swing.other())
                .then(0, side * Stance.HALF_WIDTH, side * twist / 2)
                .then(
                        slip.forward() * velocity.forward() * seconds,
                        side * (Stance.HALF_WIDTH + open),
                        side * twist / 2);
    }

    private Pose2d foot(Leg leg) {
        return leg == Leg.LEFT ? left : right;
    }

    /** Ends the step; the swing foot becomes the support foot. */
    private void setDown(Pose2d place) {
        if (swing == Leg.LEFT) {
            left = place;
        } else {
            right = place;
        }
        swing = swing.other();
        torso = step.after();
        standing = torso.amplitude() == 0;
        if (standing) {
            putFeetSideBySide();
        }
        cycle = 0;
    }

    private void putFeetSideBySide() {
        left = Stance.LEFT_FOOT;
        right = Stance.RIGHT_FOOT;
    }

    private static double smooth(double amplitude) {
        return amplitude * amplitude * (3 - 2 * amplitude);
    }
}
