package org.robonewbie.agent.walk;

import static org.robonewbie.agent.walk.WalkParameter.ANKLE_PITCH;
import static org.robonewbie.agent.walk.WalkParameter.ANKLE_PITCH_RATE;
import static org.robonewbie.agent.walk.WalkParameter.ANKLE_ROLL;
import static org.robonewbie.agent.walk.WalkParameter.ANKLE_ROLL_RATE;
import static org.robonewbie.agent.walk.WalkParameter.HIP_PITCH;
import static org.robonewbie.agent.walk.WalkParameter.HIP_PITCH_RATE;
import static org.robonewbie.agent.walk.WalkParameter.HIP_ROLL;
import static org.robonewbie.agent.walk.WalkParameter.HIP_ROLL_RATE;
import static org.robonewbie.agent.walk.WalkParameter.STEP_FORWARD;
import static org.robonewbie.agent.walk.WalkParameter.STEP_FORWARD_RATE;
import static org.robonewbie.agent.walk.WalkParameter.STEP_RIGHT;
import static org.robonewbie.agent.walk.WalkParameter.STEP_RIGHT_RATE;

import org.robonewbie.agent.walk.BalanceGains.Gain;
import org.robonewbie.nao.model.RobotType;

/**
 * Parameters of the walk engine. Most were tuned in the simulator; {@code robonewbie optimise walk-engine} tunes them further.
 *
 * @param gait parameters of a step
 * @param gains gains of the balance control
 * @param most maximum speeds
 * @param backward maximum backward speed in metres per second
 * @param change maximum change in each speed from one step to the next
 * @param leanPerSpeed forward tilt of the torso per metre per second of forward speed, degrees
 * @param ankleOffsetPerSpeed shift of the ankles forward per metre per second of forward speed, metres
 * @param leanPerChange forward tilt of the torso per metre per second of speed increase in a step, degrees
 * @param slip factors by which planned steps are longer than the resulting motion, because the feet slip
 */
public record WalkStyle(
        Gait gait,
        BalanceGains gains,
        WalkVelocity most,
        double backward,
        WalkVelocity change,
        double leanPerSpeed,
        double ankleOffsetPerSpeed,
        double leanPerChange,
        WalkVelocity slip) {

    /** Number of coordinates that {@link #of} takes. */
    public static final int PARAMETERS = WalkParameter.values().length;

    private static final double ARM_DEGREES_PER_METRE = 180;
    private static final double SWING_EASING = 0.7;

    /** The default style of {@link Walk}. */
    public static final WalkStyle STANDARD = standard(coordinates());

    /**
     * A faster but less stable walk, with twice the turn rate of {@link #STANDARD}, for advanced players.
     *
     * <pre>{@code
     * walk.setStyle(WalkStyle.FAST);
     * walk.towards(WalkStyle.FAST.most().forward(), 0, 0);
     * }</pre>
     */
    public static final WalkStyle FAST = FastWalk.style(FastWalk.coordinates());

    /**
     * Maximum requested forward speed, in metres per second, for robots of type 3, which fall if a higher speed is
     * requested. With their longer steps they actually reach 0.65 m/s.
     */
    private static final double MAX_FORWARD_OF_LONGEST_LEGS = 0.5;

    /**
     * Returns the fast walk for a robot type.
     *
     * @param type the robot type, {@code nao.getType()}
     * @return {@link #FAST}, with a lower forward speed for robots of type 3
     */
    public static WalkStyle fast(RobotType type) {
        WalkVelocity most = FAST.most();
        return type == RobotType.TYPE_3
                ? FAST.withLimits(
                        new WalkVelocity(MAX_FORWARD_OF_LONGEST_LEGS, most.left(), most.turn()),
                        FAST.backward(),
                        FAST.change())
                : FAST;
    }

    /** {@return the coordinates of the standard walk for {@link #of}, as a new array} */
    public static double[] coordinates() {
        return WalkParameter.standardCoordinates();
    }

    /**
     * Creates a variant of the standard walk with the given coordinates.
     *
     * @param x coordinates as for {@link #of}
     * @return a style with the step duration and the maximum speeds of the standard walk
     */
    public static WalkStyle standard(double[] x) {
        return of(200, new WalkVelocity(1.12, 1.25, 1.2), new WalkVelocity(0.6, 0.22, 70), x);
    }

    /**
     * Creates a style from coordinates in the search space, see {@link WalkParameter}.
     *
     * @param stepMillis duration of a step in milliseconds
     * @param slip factors by which planned steps are longer than the resulting motion
     * @param most maximum speeds
     * @param x at least {@link #PARAMETERS} coordinates
     * @return the style
     */
    public static WalkStyle of(int stepMillis, WalkVelocity slip, WalkVelocity most, double[] x) {
        BalanceGains gains = new BalanceGains(
                new Gain(ANKLE_PITCH.value(x), ANKLE_PITCH_RATE.value(x)),
                new Gain(HIP_PITCH.value(x), HIP_PITCH_RATE.value(x)),
                new Gain(ANKLE_ROLL.value(x), ANKLE_ROLL_RATE.value(x)),
                new Gain(HIP_ROLL.value(x), HIP_ROLL_RATE.value(x)),
                new Gain(STEP_FORWARD.value(x), STEP_FORWARD_RATE.value(x)),
                new Gain(STEP_RIGHT.value(x), STEP_RIGHT_RATE.value(x)));
        return new WalkStyle(
                Gait.of(stepMillis, x, ARM_DEGREES_PER_METRE, SWING_EASING),
                gains,
                most,
                0.6 * most.forward(),
                new WalkVelocity(WalkParameter.SPEED_CHANGE.value(x), 0.08, 25),
                WalkParameter.LEAN_PER_SPEED.value(x),
                WalkParameter.ANKLE_OFFSET_PER_SPEED.value(x),
                WalkParameter.LEAN_PER_CHANGE.value(x),
                slip);
    }

    /**
     * Returns a copy with the given limits.
     *
     * @param newMost maximum speeds
     * @param newBackward maximum backward speed in metres per second
     * @param newChange maximum change in each speed from one step to the next
     * @return the copy
     */
    public WalkStyle withLimits(WalkVelocity newMost, double newBackward, WalkVelocity newChange) {
        return new WalkStyle(
                gait, gains, newMost, newBackward, newChange, leanPerSpeed, ankleOffsetPerSpeed, leanPerChange, slip);
    }
}
