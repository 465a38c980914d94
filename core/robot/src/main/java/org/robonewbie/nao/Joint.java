package org.robonewbie.nao;

import java.util.Arrays;
import java.util.Optional;

/**
 * The 22 hinge joints of the NAO, in the order in which a motion file lists their angles.
 *
 * <p>An angle is the rotation of the outer limb relative to the inner one, following the right-hand rule about the
 * joint's axis. All angles are 0 in the construction pose: standing straight with both arms stretched forward. Ranges
 * and names are those of SimSpark's robot {@code rsg/agent/nao/nao.rsg}.
 *
 * <pre>{@code
 * double angle = nao.getJointAngle(Joint.LEFT_KNEE_PITCH);   // degrees, negative = bent
 * }</pre>
 */
public enum Joint {
    /** Turns the head; positive is to the left. NAO: HeadYaw; SimSpark: hinge hj1, motor he1. */
    NECK_YAW("HeadYaw", "hj1", "he1", -120, 120),
    /** Nods the head; positive is up. NAO: HeadPitch; SimSpark: hinge hj2, motor he2. */
    NECK_PITCH("HeadPitch", "hj2", "he2", -45, 45),
    /** Swings the left arm; 0 is stretched forward, positive lifts it. NAO: LShoulderPitch; SimSpark: hinge laj1, motor lae1. */
    LEFT_SHOULDER_PITCH("LShoulderPitch", "laj1", "lae1", -120, 120),
    /** Swings the left arm sideways; positive is outward. NAO: LShoulderRoll; SimSpark: hinge laj2, motor lae2. */
    LEFT_SHOULDER_YAW("LShoulderRoll", "laj2", "lae2", -1, 95),
    /**
     * Turns the left forearm about its own axis; right-hand rule about the forearm. NAO: LElbowYaw; SimSpark: hinge
     * laj3, motor lae3.
     */
    LEFT_ARM_ROLL("LElbowYaw", "laj3", "lae3", -120, 120),
    /** Bends the left elbow; negative is inward. NAO: LElbowRoll; SimSpark: hinge laj4, motor lae4. */
    LEFT_ARM_YAW("LElbowRoll", "laj4", "lae4", -90, 1),
    /**
     * Turns the left leg about an axis tilted by 45°; negative turns the toes outward and lifts the thigh. NAO: LHipYawPitch;
     * SimSpark: hinge llj1, motor lle1.
     */
    LEFT_HIP_YAW_PITCH("LHipYawPitch", "llj1", "lle1", -90, 1),
    /** Swings the left leg sideways; positive is outward. NAO: LHipRoll; SimSpark: hinge llj2, motor lle2. */
    LEFT_HIP_ROLL("LHipRoll", "llj2", "lle2", -25, 45),
    /** Swings the left thigh; positive is forward. NAO: LHipPitch; SimSpark: hinge llj3, motor lle3. */
    LEFT_HIP_PITCH("LHipPitch", "llj3", "lle3", -25, 100),
    /** Bends the left knee; 0 is straight, negative is bent. NAO: LKneePitch; SimSpark: hinge llj4, motor lle4. */
    LEFT_KNEE_PITCH("LKneePitch", "llj4", "lle4", -130, 1),
    /** Tilts the left foot forward and back; positive lifts the toes. NAO: LAnklePitch; SimSpark: hinge llj5, motor lle5. */
    LEFT_FOOT_PITCH("LAnklePitch", "llj5", "lle5", -45, 75),
    /**
     * Tilts the left foot sideways; right-hand rule about the forward axis. NAO: LAnkleRoll; SimSpark: hinge llj6,
     * motor lle6.
     */
    LEFT_FOOT_ROLL("LAnkleRoll", "llj6", "lle6", -45, 25),
    /**
     * Turns the right leg about an axis tilted by 45°; negative turns the toes outward and lifts the thigh. NAO: RHipYawPitch;
     * SimSpark: hinge rlj1, motor rle1.
     */
    RIGHT_HIP_YAW_PITCH("RHipYawPitch", "rlj1", "rle1", -90, 1),
    /** Swings the right leg sideways; negative is outward. NAO: RHipRoll; SimSpark: hinge rlj2, motor rle2. */
    RIGHT_HIP_ROLL("RHipRoll", "rlj2", "rle2", -45, 25),
    /** Swings the right thigh; positive is forward. NAO: RHipPitch; SimSpark: hinge rlj3, motor rle3. */
    RIGHT_HIP_PITCH("RHipPitch", "rlj3", "rle3", -25, 100),
    /** Bends the right knee; 0 is straight, negative is bent. NAO: RKneePitch; SimSpark: hinge rlj4, motor rle4. */
    RIGHT_KNEE_PITCH("RKneePitch", "rlj4", "rle4", -130, 1),
    /** Tilts the right foot forward and back; positive lifts the toes. NAO: RAnklePitch; SimSpark: hinge rlj5, motor rle5. */
    RIGHT_FOOT_PITCH("RAnklePitch", "rlj5", "rle5", -45, 75),
    /**
     * Tilts the right foot sideways; right-hand rule about the forward axis. NAO: RAnkleRoll; SimSpark: hinge rlj6,
     * motor rle6.
     */
    RIGHT_FOOT_ROLL("RAnkleRoll", "rlj6", "rle6", -25, 45),
    /** Swings the right arm; 0 is stretched forward, positive lifts it. NAO: RShoulderPitch; SimSpark: hinge raj1, motor rae1. */
    RIGHT_SHOULDER_PITCH("RShoulderPitch", "raj1", "rae1", -120, 120),
    /** Swings the right arm sideways; negative is outward. NAO: RShoulderRoll; SimSpark: hinge raj2, motor rae2. */
    RIGHT_SHOULDER_YAW("RShoulderRoll", "raj2", "rae2", -95, 1),
    /**
     * Turns the right forearm about its own axis; right-hand rule about the forearm. NAO: RElbowYaw; SimSpark: hinge
     * raj3, motor rae3.
     */
    RIGHT_ARM_ROLL("RElbowYaw", "raj3", "rae3", -120, 120),
    /** Bends the right elbow; positive is inward. NAO: RElbowRoll; SimSpark: hinge raj4, motor rae4. */
    RIGHT_ARM_YAW("RElbowRoll", "raj4", "rae4", -1, 90);

    /** The number of joints. */
    public static final int COUNT = 22;

    private static final double MAX_DEGREES_PER_SECOND = 351.77;

    private final String standardName;
    private final String perceptorName;
    private final String effectorName;
    private final double minDegrees;
    private final double maxDegrees;

    Joint(String standardName, String perceptorName, String effectorName, double minDegrees, double maxDegrees) {
        this.standardName = standardName;
        this.perceptorName = perceptorName;
        this.effectorName = effectorName;
        this.minDegrees = minDegrees;
        this.maxDegrees = maxDegrees;
    }

    /** {@return the name that the NAO's manufacturer and the literature use, such as {@code LElbowRoll}} */
    public String standardName() {
        return standardName;
    }

    /** {@return the name of the joint's sensor in SimSpark's messages, such as {@code llj4}} */
    public String perceptorName() {
        return perceptorName;
    }

    /** {@return the name of the joint's motor in SimSpark's messages, such as {@code lle4}} */
    public String effectorName() {
        return effectorName;
    }

    /**
     * Returns the joint that a motor drives.
     *
     * @param effectorName the motor's name in SimSpark's messages, such as {@code lle4}
     * @return the joint; empty if robot type 0 has no such motor, for example for a toe motor
     */
    public static Optional<Joint> ofEffector(String effectorName) {
        return Arrays.stream(values())
                .filter(joint -> joint.effectorName.equals(effectorName))
                .findFirst();
    }

    /** {@return the smallest angle of the joint's range in degrees} */
    public double minDegrees() {
        return minDegrees;
    }

    /** {@return the largest angle of the joint's range in degrees} */
    public double maxDegrees() {
        return maxDegrees;
    }

    /**
     * {@return the maximum speed of the motor in either direction, in degrees per second; the same for every joint of robot
     * type 0}
     */
    public double maxDegreesPerSecond() {
        return MAX_DEGREES_PER_SECOND;
    }

    /**
     * Clamps an angle to this joint's range.
     *
     * @param degrees any angle in degrees; not NaN
     * @return the nearest angle within the range, in degrees
     */
    public double clampDegrees(double degrees) {
        return Math.max(minDegrees, Math.min(maxDegrees, degrees));
    }
}
