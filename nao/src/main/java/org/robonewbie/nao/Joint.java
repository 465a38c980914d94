package org.robonewbie.nao;

/**
 * The 22 hinge joints of the NAO, in the order in which a motion file lists their angles.
 *
 * <p>An angle is the rotation of the outer limb against the inner one by the right-hand rule about the joint's axis;
 * it is 0 in the construction pose: standing straight, both arms stretched forward. Ranges and names are those of
 * SimSpark's robot {@code rsg/agent/nao/nao.rsg}.
 *
 * <pre>{@code
 * double angle = nao.getJointAngle(Joint.LEFT_KNEE_PITCH);   // degrees, negative = bent
 * }</pre>
 */
public enum Joint {
    /** Head turns; positive looks to the left. */
    NECK_YAW("hj1", "he1", -120, 120),
    /** Head nods; positive looks up. */
    NECK_PITCH("hj2", "he2", -45, 45),
    /** Left arm swings; 0 is stretched forward, positive lifts it. */
    LEFT_SHOULDER_PITCH("laj1", "lae1", -120, 120),
    /** Left arm opens; positive is outward. */
    LEFT_SHOULDER_YAW("laj2", "lae2", -1, 95),
    /** Left forearm turns about its own axis; right-hand rule about the forearm. */
    LEFT_ARM_ROLL("laj3", "lae3", -120, 120),
    /** Left elbow; negative bends inward. */
    LEFT_ARM_YAW("laj4", "lae4", -90, 1),
    /** Left leg turns about an axis tilted by 45°; negative turns the toes outward and lifts the thigh. */
    LEFT_HIP_YAW_PITCH("llj1", "lle1", -90, 1),
    /** Left leg to the side; positive is outward. */
    LEFT_HIP_ROLL("llj2", "lle2", -25, 45),
    /** Left thigh; positive swings it forward. */
    LEFT_HIP_PITCH("llj3", "lle3", -25, 100),
    /** Left knee; negative bends it. */
    LEFT_KNEE_PITCH("llj4", "lle4", -130, 1),
    /** Left ankle; positive lifts the toes. */
    LEFT_FOOT_PITCH("llj5", "lle5", -45, 75),
    /** Left ankle to the side; right-hand rule about the forward axis. */
    LEFT_FOOT_ROLL("llj6", "lle6", -45, 25),
    /** Right leg turns about an axis tilted by 45°; negative turns the toes outward and lifts the thigh. */
    RIGHT_HIP_YAW_PITCH("rlj1", "rle1", -90, 1),
    /** Right leg to the side; negative is outward. */
    RIGHT_HIP_ROLL("rlj2", "rle2", -45, 25),
    /** Right thigh; positive swings it forward. */
    RIGHT_HIP_PITCH("rlj3", "rle3", -25, 100),
    /** Right knee; negative bends it. */
    RIGHT_KNEE_PITCH("rlj4", "rle4", -130, 1),
    /** Right ankle; positive lifts the toes. */
    RIGHT_FOOT_PITCH("rlj5", "rle5", -45, 75),
    /** Right ankle to the side; right-hand rule about the forward axis. */
    RIGHT_FOOT_ROLL("rlj6", "rle6", -25, 45),
    /** Right arm swings; 0 is stretched forward, positive lifts it. */
    RIGHT_SHOULDER_PITCH("raj1", "rae1", -120, 120),
    /** Right arm opens; negative is outward. */
    RIGHT_SHOULDER_YAW("raj2", "rae2", -95, 1),
    /** Right forearm turns about its own axis; right-hand rule about the forearm. */
    RIGHT_ARM_ROLL("raj3", "rae3", -120, 120),
    /** Right elbow; positive bends inward. */
    RIGHT_ARM_YAW("raj4", "rae4", -1, 90);

    /** How many joints the robot has: 22. */
    public static final int COUNT = 22;

    private static final double MAX_DEGREES_PER_SECOND = 351.77;

    private final String perceptorName;
    private final String effectorName;
    private final double minDegrees;
    private final double maxDegrees;

    Joint(String perceptorName, String effectorName, double minDegrees, double maxDegrees) {
        this.perceptorName = perceptorName;
        this.effectorName = effectorName;
        this.minDegrees = minDegrees;
        this.maxDegrees = maxDegrees;
    }

    /**
     * Names the joint's sensor in SimSpark's messages.
     *
     * @return the perceptor name, such as {@code llj4}
     */
    public String perceptorName() {
        return perceptorName;
    }

    /**
     * Names the joint's motor in SimSpark's messages.
     *
     * @return the effector name, such as {@code lle4}
     */
    public String effectorName() {
        return effectorName;
    }

    /**
     * Tells the lower end of the range.
     *
     * @return the smallest angle in degrees
     */
    public double minDegrees() {
        return minDegrees;
    }

    /**
     * Tells the upper end of the range.
     *
     * @return the largest angle in degrees
     */
    public double maxDegrees() {
        return maxDegrees;
    }

    /**
     * Tells how fast the motor can turn in either direction.
     *
     * @return the largest speed in degrees per second, the same for every joint of robot type 0
     */
    public double maxDegreesPerSecond() {
        return MAX_DEGREES_PER_SECOND;
    }

    /**
     * Forces an angle into this joint's range.
     *
     * @param degrees any angle in degrees; not NaN
     * @return the nearest angle within the range, in degrees
     */
    public double clampDegrees(double degrees) {
        return Math.max(minDegrees, Math.min(maxDegrees, degrees));
    }
}
