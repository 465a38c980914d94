package org.robonewbie.protocol.perceptor;

import java.util.Arrays;
import java.util.List;
import java.util.OptionalDouble;
import java.util.function.ToDoubleFunction;
import org.robonewbie.nao.Joint;

/** The angles of all hinges in degrees: perceptor {@code HJ}. Immutable. */
public final class JointAngles {

    /** No angles. */
    public static final JointAngles NONE = new JointAngles(new double[Joint.COUNT], 0, List.of());

    private static final Joint[] JOINTS = Joint.values();
    private static final int ALL = (1 << Joint.COUNT) - 1;

    private final double[] degrees;
    private final int present;
    private final List<ExtraHinge> extraHinges;

    /**
     * The angle of a hinge that is not a {@link Joint}, such as the toes {@code llj7} and {@code rlj7} of robot type 4.
     *
     * @param perceptorName the hinge's name in SimSpark's messages
     * @param degrees its angle in degrees
     */
    public record ExtraHinge(String perceptorName, double degrees) {}

    /** Takes ownership of the array; the bit of a joint's ordinal shows whether its angle is present. */
    JointAngles(double[] degrees, int present, List<ExtraHinge> extraHinges) {
        this.degrees = degrees;
        this.present = present;
        this.extraHinges = List.copyOf(extraHinges);
    }

    /**
     * Collects the angles of all joints.
     *
     * @param degrees 22 angles in degrees in the order of {@link Joint}; copied
     * @return the angles
     * @throws IllegalArgumentException if there are not 22 angles
     */
    public static JointAngles of(double... degrees) {
        return of(degrees, List.of());
    }

    /**
     * Collects the angles of all joints and of additional hinges.
     *
     * @param degrees 22 angles in degrees in the order of {@link Joint}; copied
     * @param extraHinges angles of hinges that are not joints, such as toes
     * @return the angles
     * @throws IllegalArgumentException if there are not 22 angles
     */
    public static JointAngles of(double[] degrees, List<ExtraHinge> extraHinges) {
        if (degrees.length != Joint.COUNT) {
            throw new IllegalArgumentException("A robot has " + Joint.COUNT + " joint angles, not " + degrees.length);
        }
        return new JointAngles(degrees.clone(), ALL, extraHinges);
    }

    /**
     * Measures the angles of all joints.
     *
     * @param degrees measures the angle of a joint in degrees
     * @param extraHinges angles of hinges that are not joints, such as toes
     * @return the angles
     */
    public static JointAngles measured(ToDoubleFunction<Joint> degrees, List<ExtraHinge> extraHinges) {
        double[] all = new double[Joint.COUNT];
        for (Joint joint : JOINTS) {
            all[joint.ordinal()] = degrees.applyAsDouble(joint);
        }
        return new JointAngles(all, ALL, extraHinges);
    }

    /**
     * Looks up an angle.
     *
     * @param joint the joint
     * @return its angle in degrees, which may exceed the joint's range slightly; empty if the message has none
     */
    public OptionalDouble degrees(Joint joint) {
        return has(joint) ? OptionalDouble.of(degrees[joint.ordinal()]) : OptionalDouble.empty();
    }

    /**
     * Looks up an angle, with a default.
     *
     * @param joint the joint
     * @param otherwise the result if the message has no angle of this joint
     * @return its angle in degrees
     */
    public double degreesOr(Joint joint, double otherwise) {
        return has(joint) ? degrees[joint.ordinal()] : otherwise;
    }

    /**
     * Returns whether the message has an angle of a joint.
     *
     * @param joint the joint
     * @return whether it has
     */
    public boolean has(Joint joint) {
        return (present & 1 << joint.ordinal()) != 0;
    }

    /**
     * {@return the angles of hinges that are not a {@link Joint}: the toes of robot type 4 and whatever else a server sends}
     */
    public List<ExtraHinge> extraHinges() {
        return extraHinges;
    }

    @Override
    public boolean equals(Object other) {
        return other instanceof JointAngles that
                && present == that.present
                && Arrays.equals(degrees, that.degrees)
                && extraHinges.equals(that.extraHinges);
    }

    @Override
    public int hashCode() {
        return 31 * Arrays.hashCode(degrees) + extraHinges.hashCode();
    }

    @Override
    public String toString() {
        return "JointAngles" + Arrays.toString(degrees) + extraHinges;
    }
}
