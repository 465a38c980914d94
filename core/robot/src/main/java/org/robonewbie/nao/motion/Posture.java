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
    public static final Posture ZERO = new Posture(JointSpace.NAO, new double[JointSpace.NAO.size()]);

    private final JointSpace space;
    private final double[] degrees;

    /** Takes ownership of the array. Negative zeros become positive, so that equal angles have equal bits. */
    private Posture(JointSpace space, double[] degrees) {
        this.space = space;
        for (int i = 0; i < degrees.length; i++) {
            degrees[i] += 0.0;
        }
        this.degrees = degrees;
    }

    /**
     * Creates a posture of the NAO.
     *
     * @param degrees 22 angles in degrees in the order of {@link Joint}; copied
     * @return the posture
     * @throws IllegalArgumentException if there are not 22 angles or one is not finite
     */
    public static Posture of(double... degrees) {
        return of(JointSpace.NAO, degrees);
    }

    /**
     * Creates a posture of any robot.
     *
     * @param space the joints of the robot
     * @param degrees one angle in degrees for each joint; copied
     * @return the posture
     * @throws IllegalArgumentException if the number of angles is not the number of joints or one is not finite
     */
    public static Posture of(JointSpace space, double... degrees) {
        if (degrees.length != space.size()) {
            throw new IllegalArgumentException(
                    "Expected " + space.size() + " angles, one for each joint, but got " + degrees.length + ".");
        }
        for (int i = 0; i < degrees.length; i++) {
            checkFinite(space, i, degrees[i]);
        }
        return new Posture(space, degrees.clone());
    }

    /** {@return the joints of the robot that takes this posture} */
    public JointSpace jointSpace() {
        return space;
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
     * Returns the angle of a joint of any robot.
     *
     * @param joint index of the joint in {@link #jointSpace()}
     * @return its angle in degrees
     */
    public double degrees(int joint) {
        return degrees[joint];
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
        return with(List.of(joint), newDegrees);
    }

    /**
     * Returns the mirrored posture of a NAO.
     *
     * @return the posture with left and right exchanged
     * @throws IllegalStateException if this is the posture of another robot
     */
    public Posture mirrored() {
        if (!space.equals(JointSpace.NAO)) {
            throw new IllegalStateException("A posture of the robot " + space.robot()
                    + " cannot be mirrored: which joints belong together is known for the NAO only.");
        }
        double[] mirrored = new double[degrees.length];
        for (Joint joint : Joint.values()) {
            mirrored[Mirror.partner(joint).ordinal()] = Mirror.mirroredDegrees(joint, degrees(joint));
        }
        return new Posture(space, mirrored);
    }

    /** {@return this posture with each angle clamped to its joint's range} */
    public Posture clamped() {
        double[] clamped = new double[degrees.length];
        for (int i = 0; i < clamped.length; i++) {
            clamped[i] = space.joints().get(i).clampDegrees(degrees[i]);
        }
        return new Posture(space, clamped);
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
            int index = joints.get(i).ordinal();
            checkFinite(space, index, newDegrees[i]);
            changed[index] = newDegrees[i];
        }
        return new Posture(space, changed);
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
        double[] between = new double[degrees.length];
        for (int i = 0; i < between.length; i++) {
            between[i] = degrees[i] + fraction * (end.degrees[i] - degrees[i]);
        }
        return new Posture(space, between);
    }

    /**
     * Returns the largest difference in a joint angle between this posture and another one.
     *
     * @param other the other posture
     * @return the largest difference in degrees, at least 0
     */
    public double largestDifference(Posture other) {
        double largest = 0;
        for (int i = 0; i < degrees.length; i++) {
            largest = Math.max(largest, Math.abs(degrees[i] - other.degrees[i]));
        }
        return largest;
    }

    /** {@return a new array of the angles in degrees in the order of {@link #jointSpace()}, for the NAO that of {@link Joint}} */
    public double[] toArray() {
        return degrees.clone();
    }

    private static void checkFinite(JointSpace space, int joint, double degrees) {
        if (!Double.isFinite(degrees)) {
            throw new IllegalArgumentException("Angle " + degrees + " for "
                    + space.joints().get(joint).name() + " is not a finite number. Was something divided by zero?");
        }
    }

    @Override
    public boolean equals(Object other) {
        return other instanceof Posture that && Arrays.equals(degrees, that.degrees) && space.equals(that.space);
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
