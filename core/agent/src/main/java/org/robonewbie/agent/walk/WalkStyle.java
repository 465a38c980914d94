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
 * @param gait how the robot steps
 * @param gains how it keeps its balance
 * @param most the largest speeds
 * @param backward the largest speed backward, metres per second
 * @param change how much each speed changes from one step to the next
 * @param leanPerSpeed degrees that the torso bends forward for each metre per second
 * @param ankleOffsetPerSpeed metres that the ankles stand further ahead for each metre per second
 * @param leanPerChange degrees that the torso bends forward for each metre per second that the walk becomes faster in a step
 * @param slip by which factors the steps are planned longer than the robot is meant to get, since its feet slip
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

    /** How many numbers {@link #of} takes. */
    public static final int PARAMETERS = WalkParameter.values().length;

    private static final double ARM_DEGREES_PER_METRE = 180;

    /** The walk of {@link Walk}. */
    public static final WalkStyle STANDARD = standard(coordinates());

    /**
     * A walk that is faster forward and turns twice as fast, for players who know what they do: it is less steady.
     *
     * <pre>{@code
     * walk.setStyle(WalkStyle.FAST);
     * walk.towards(WalkStyle.FAST.most().forward(), 0, 0);
     * }</pre>
     */
    public static final WalkStyle FAST = FastWalk.style(FastWalk.coordinates());

    /** With more a robot of type 3 falls within a few metres; its steps are longer, and it gets 0.65 m/s. */
    private static final double MAX_FORWARD_OF_LONGEST_LEGS = 0.5;

    /**
     * Returns the fast walk for a robot of some build.
     *
     * @param type how it is built, {@code nao.getType()}
     * @return {@link #FAST}, for robots of type 3 with less speed forward
     */
    public static WalkStyle fast(RobotType type) {
        WalkVelocity most = FAST.most();
        return type == RobotType.TYPE_3
                ? FAST.withMost(
                        new WalkVelocity(MAX_FORWARD_OF_LONGEST_LEGS, most.left(), most.turn()), FAST.backward())
                : FAST;
    }

    /** {@return the coordinates that {@link #of} takes for the standard walk, a new array} */
    public static double[] coordinates() {
        return WalkParameter.standardCoordinates();
    }

    /**
     * Creates the standard walk with other coordinates.
     *
     * @param x coordinates as for {@link #of}
     * @return a walk with the same step time and the same largest speeds
     */
    public static WalkStyle standard(double[] x) {
        return of(200, new WalkVelocity(1.12, 1.25, 1.2), new WalkVelocity(0.6, 0.22, 70), x);
    }

    /**
     * Returns the same walk with other limits, for a player that wants to be steadier than fast.
     *
     * @param newMost the largest speeds
     * @param newChange how much each speed changes from one step to the next
     * @return the changed walk
     */
    public WalkStyle within(WalkVelocity newMost, WalkVelocity newChange) {
        return new WalkStyle(
                gait,
                gains,
                newMost,
                Math.min(backward, newMost.forward()),
                newChange,
                leanPerSpeed,
                ankleOffsetPerSpeed,
                leanPerChange,
                slip);
    }

    /**
     * Makes a style from the coordinates of a search, see {@link WalkParameter}.
     *
     * @param stepMillis time of one step in milliseconds
     * @param slip by which factors the steps are planned longer than the robot is meant to get
     * @param most the largest speeds
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
                Gait.of(stepMillis, 1, x).withArmSwing(ARM_DEGREES_PER_METRE),
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
     * Changes the largest speeds.
     *
     * @param newMost the largest speeds
     * @param newBackward the largest speed backward, metres per second
     * @return the same walk with other limits
     */
    public WalkStyle withMost(WalkVelocity newMost, double newBackward) {
        return new WalkStyle(
                gait, gains, newMost, newBackward, change, leanPerSpeed, ankleOffsetPerSpeed, leanPerChange, slip);
    }
}
