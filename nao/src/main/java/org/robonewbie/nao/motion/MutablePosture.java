package org.robonewbie.nao.motion;

import org.robonewbie.nao.Joint;

/**
 * A posture that changes: for calculations in each cycle, which shall make no garbage. What is finished is a {@link Posture}.
 *
 * <pre>{@code
 * MutablePosture posture = new MutablePosture(Posture.ZERO);
 * posture.add(Joint.LEFT_SHOULDER_PITCH, 60);
 * }</pre>
 */
public final class MutablePosture {

    private static final Joint[] JOINTS = Joint.values();

    private final double[] degrees;

    /**
     * Begins with a posture.
     *
     * @param start the posture, which does not change
     */
    public MutablePosture(Posture start) {
        degrees = start.toArray();
    }

    /**
     * Looks up an angle.
     *
     * @param joint the joint
     * @return its angle in degrees
     */
    public double degrees(Joint joint) {
        return degrees[joint.ordinal()];
    }

    /**
     * Changes an angle.
     *
     * @param joint the joint
     * @param newDegrees its new angle in degrees, finite
     */
    public void set(Joint joint, double newDegrees) {
        degrees[joint.ordinal()] = newDegrees;
    }

    /**
     * Turns a joint further.
     *
     * @param joint the joint
     * @param moreDegrees what is added to its angle, in degrees
     */
    public void add(Joint joint, double moreDegrees) {
        degrees[joint.ordinal()] += moreDegrees;
    }

    /**
     * Takes over all angles.
     *
     * @param posture another posture
     */
    public void set(Posture posture) {
        for (Joint joint : JOINTS) {
            degrees[joint.ordinal()] = posture.degrees(joint);
        }
    }

    /**
     * Takes a posture between two.
     *
     * @param from the one end
     * @param to the other end
     * @param fraction 0 for the one, 1 for the other
     */
    public void setBetween(Posture from, MutablePosture to, double fraction) {
        for (Joint joint : JOINTS) {
            double begin = from.degrees(joint);
            degrees[joint.ordinal()] =
                    fraction == 1 ? to.degrees(joint) : begin + fraction * (to.degrees(joint) - begin);
        }
    }

    /** Forces all angles into their joints' ranges. */
    public void clamp() {
        for (Joint joint : JOINTS) {
            degrees[joint.ordinal()] = joint.clampDegrees(degrees[joint.ordinal()]);
        }
    }

    /**
     * Makes a posture that stays as it is.
     *
     * @return the angles of now
     */
    public Posture toPosture() {
        return Posture.of(degrees);
    }
}
