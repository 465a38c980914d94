package org.robonewbie.protocol.perceptor;

import java.util.Arrays;
import java.util.List;
import java.util.Map;
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
     * The angle of a hinge that is not a {@link Joint}, such as the toe hinges {@code llj7} and {@code rlj7} of robot
     * type 4.
     *
     * @param perceptorName the hinge's name in SimSpark's messages
     * @param degrees its angle in degrees
     */
    public record ExtraHinge(String perceptorName, double degrees) {}

    /**
     * Takes ownership of the array. Bit {@code n} of {@code present} is set if the angle of the joint with ordinal {@code n} is
     * known.
     */
    JointAngles(double[] degrees, int present, List<ExtraHinge> extraHinges) {
        this.degrees = degrees;
        this.present = present;
        this.extraHinges = List.copyOf(extraHinges);
    }

    /**
     * Creates readings with the angle of every joint.
     *
     * @param degrees function from a joint to its angle in degrees
     * @param extraHinges angles of hinges that are not a {@link Joint}, such as toe hinges
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
     * Creates readings with the angles of some joints.
     *
     * @param degrees angles in degrees
     * @return the angles
     */
    public static JointAngles of(Map<Joint, Double> degrees) {
        double[] all = new double[Joint.COUNT];
        int present = 0;
        for (Map.Entry<Joint, Double> joint : degrees.entrySet()) {
            all[joint.getKey().ordinal()] = joint.getValue();
            present |= 1 << joint.getKey().ordinal();
        }
        return new JointAngles(all, present, List.of());
    }

    /**
     * Returns the angle of a joint.
     *
     * @param joint the joint
     * @return its angle in degrees, which may slightly exceed the joint's range; empty if the message does not contain it
     */
    public OptionalDouble degrees(Joint joint) {
        return has(joint) ? OptionalDouble.of(degrees[joint.ordinal()]) : OptionalDouble.empty();
    }

    /**
     * Returns the angle of a joint, or a default if it is unknown.
     *
     * @param joint the joint
     * @param otherwise default in degrees, for a joint whose angle the message does not contain
     * @return its angle in degrees
     */
    public double degreesOr(Joint joint, double otherwise) {
        return has(joint) ? degrees[joint.ordinal()] : otherwise;
    }

    /**
     * Returns whether the message contains the angle of a joint.
     *
     * @param joint the joint
     * @return whether its angle is known
     */
    public boolean has(Joint joint) {
        return (present & 1 << joint.ordinal()) != 0;
    }

    /** {@return the angles of hinges that are not a {@link Joint}, such as the toe hinges of robot type 4} */
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
