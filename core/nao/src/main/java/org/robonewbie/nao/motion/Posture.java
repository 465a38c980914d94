package org.robonewbie.nao.motion;

import java.util.Arrays;
import java.util.List;
import org.robonewbie.nao.Joint;

/**
 * The posture of the whole body: one angle for each joint. Immutable.
 *
 * <pre>{@code
 * Posture raisedArm = Posture.ZERO.with(Joint.LEFT_SHOULDER_PITCH, 60);
 * }</pre>
 */
public final class Posture {

    /** The construction pose: standing straight, both arms stretched forward, all angles 0. */
    public static final Posture ZERO = new Posture(new double[Joint.COUNT]);

    private static final Joint[] JOINTS = Joint.values();

    private final double[] degrees;

    /** Takes ownership of the array. Negative zeros become positive, so that equal angles have equal bits. */
    private Posture(double[] degrees) {
        for (int i = 0; i < degrees.length; i++) {
            degrees[i] += 0.0;
        }
        this.degrees = degrees;
    }

    /**
     * Creates a posture.
     *
     * @param degrees 22 angles in degrees in the order of {@link Joint}; copied
     * @return the posture
     * @throws IllegalArgumentException if there are not 22 angles or one is not finite
     */
    public static Posture of(double... degrees) {
        if (degrees.length != Joint.COUNT) {
            throw new IllegalArgumentException(
                    "Expected " + Joint.COUNT + " angles, one for each joint, but got " + degrees.length + ".");
        }
        for (int i = 0; i < degrees.length; i++) {
            checkFinite(JOINTS[i], degrees[i]);
        }
        return new Posture(degrees.clone());
    }

    /**
     * Returns the angle of a joint.
     *
     * @param joint the joint
     * @return its angle in degrees
     */
    public double degrees(Joint joint) {
        return degrees[joint.ordinal()];
    }

    /**
     * Returns this posture with one angle changed.
     *
     * @param joint the joint
     * @param newDegrees its new angle in degrees
     * @return the changed posture
     * @throws IllegalArgumentException if the angle is not finite
     */
    public Posture with(Joint joint, double newDegrees) {
        checkFinite(joint, newDegrees);
        double[] changed = degrees.clone();
        changed[joint.ordinal()] = newDegrees;
        return new Posture(changed);
    }

    /** {@return the mirrored posture, with left and right exchanged} */
    public Posture mirrored() {
        double[] mirrored = new double[Joint.COUNT];
        for (Joint joint : JOINTS) {
            mirrored[Mirror.partner(joint).ordinal()] = Mirror.mirroredDegrees(joint, degrees(joint));
        }
        return new Posture(mirrored);
    }

    /** {@return this posture with each angle clamped to its joint's range} */
    public Posture clamped() {
        double[] clamped = new double[Joint.COUNT];
        for (Joint joint : JOINTS) {
            clamped[joint.ordinal()] = joint.clampDegrees(degrees(joint));
        }
        return new Posture(clamped);
    }

    /**
     * Returns this posture with several angles changed.
     *
     * @param joints the joints
     * @param newDegrees their new angles in degrees, in the same order
     * @return the changed posture
     * @throws IllegalArgumentException if an angle is not finite
     */
    public Posture with(List<Joint> joints, double... newDegrees) {
        double[] changed = degrees.clone();
        for (int i = 0; i < newDegrees.length; i++) {
            checkFinite(joints.get(i), newDegrees[i]);
            changed[joints.get(i).ordinal()] = newDegrees[i];
        }
        return new Posture(changed);
    }

    /**
     * Interpolates linearly between this posture and another one.
     *
     * @param end the other posture
     * @param fraction 0 for this posture, 1 for the other
     * @return the interpolated posture
     */
    public Posture towards(Posture end, double fraction) {
        if (fraction == 1) {
            return end;
        }
        double[] between = new double[Joint.COUNT];
        for (int i = 0; i < Joint.COUNT; i++) {
            between[i] = degrees[i] + fraction * (end.degrees[i] - degrees[i]);
        }
        return new Posture(between);
    }

    /**
     * Returns the largest difference in a joint angle between this posture and another one.
     *
     * @param other the other posture
     * @return the largest difference in degrees, at least 0
     */
    public double largestDifference(Posture other) {
        double largest = 0;
        for (int i = 0; i < Joint.COUNT; i++) {
            largest = Math.max(largest, Math.abs(degrees[i] - other.degrees[i]));
        }
        return largest;
    }

    /** {@return a new array of the 22 angles in degrees in the order of {@link Joint}} */
    public double[] toArray() {
        return degrees.clone();
    }

    private static void checkFinite(Joint joint, double degrees) {
        if (!Double.isFinite(degrees)) {
            throw new IllegalArgumentException(
                    "Angle " + degrees + " for " + joint + " is not a finite number. Was something divided by zero?");
        }
    }

    @Override
    public boolean equals(Object other) {
        return other instanceof Posture that && Arrays.equals(degrees, that.degrees);
    }

    @Override
    public int hashCode() {
        return Arrays.hashCode(degrees);
    }

    @Override
    public String toString() {
        return "Posture" + Arrays.toString(degrees);
    }
}
