package org.robonewbie.nao.motion;

import java.util.Arrays;
import java.util.List;
import org.robonewbie.nao.Joint;

/**
 * The joints of a robot in the order in which its motion files list their angles.
 *
 * <pre>{@code
 * MotionFile nod = MotionFiles.load(Path.of("nod.txt"), BoosterT1.MODEL.jointSpace());
 * }</pre>
 *
 * @param robot name of the robot, as in the line {@code // robot:} of its motion files
 * @param joints the joints
 */
public record JointSpace(String robot, List<Limits> joints) {

    /** The joints of the NAO in the order of {@link Joint}. */
    public static final JointSpace NAO = new JointSpace(
            "NAO",
            Arrays.stream(Joint.values())
                    .map(joint -> new Limits(
                            joint.name(), joint.minDegrees(), joint.maxDegrees(), joint.maxDegreesPerSecond()))
                    .toList());

    /** Stores an unmodifiable copy of the list. */
    public JointSpace {
        joints = List.copyOf(joints);
    }

    /** {@return the number of joints} */
    public int size() {
        return joints.size();
    }

    /**
     * Range and speed of a joint.
     *
     * @param name name of the joint, unique within the robot
     * @param minDegrees smallest angle of the range in degrees
     * @param maxDegrees largest angle of the range in degrees
     * @param maxDegreesPerSecond maximum speed in either direction in degrees per second; infinite if the motor has no
     *     fixed limit
     */
    public record Limits(String name, double minDegrees, double maxDegrees, double maxDegreesPerSecond) {

        /**
         * Clamps an angle to the joint's range.
         *
         * @param degrees any angle in degrees; not NaN
         * @return the nearest angle within the range, in degrees
         */
        public double clampDegrees(double degrees) {
            return Math.max(minDegrees, Math.min(maxDegrees, degrees));
        }
    }
}
