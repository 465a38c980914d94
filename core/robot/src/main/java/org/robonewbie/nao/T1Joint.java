package org.robonewbie.nao;

/**
 * The 23 joints of the Booster T1 of today's league, in the order of its messages.
 *
 * <p>An angle is the rotation of the outer part relative to the inner one, following the right-hand rule: about x (forward) for a roll,
 * y (left) for a pitch, z (up) for a yaw, as the axes are while all joints are at 0 degrees. These are the angles of the league's
 * server; those of arms and head differ from the angles of {@link Joint} on a T1, which are a NAO's.
 *
 * <pre>{@code
 * nao.setJointAngle(T1Joint.WAIST, 30);
 * }</pre>
 */
public enum T1Joint {
    /** Turns the head; positive to the left. */
    NECK_YAW(-90, 90),
    /** Nods; positive looks down. */
    NECK_PITCH(-20.1, 69.9),
    /** Swings the left arm; positive backwards. */
    LEFT_SHOULDER_PITCH(-189.6, 69.9),
    /** Rolls the left upper arm; positive raises it. */
    LEFT_SHOULDER_ROLL(-99.7, 90),
    /** Twists the left upper arm. */
    LEFT_ELBOW_PITCH(-130.1, 130.1),
    /** Bends the left elbow. */
    LEFT_ELBOW_YAW(-139.8, 0),
    /** Swings the right arm; positive backwards. */
    RIGHT_SHOULDER_PITCH(-189.6, 69.9),
    /** Rolls the right upper arm; positive lowers it. */
    RIGHT_SHOULDER_ROLL(-90, 99.7),
    /** Twists the right upper arm. */
    RIGHT_ELBOW_PITCH(-130.1, 130.1),
    /** Bends the right elbow. */
    RIGHT_ELBOW_YAW(0, 139.8),
    /** Turns the upper body against the legs; positive to the left. */
    WAIST(-90, 90),
    /** Swings the left leg; positive backwards. */
    LEFT_HIP_PITCH(-103.1, 90),
    /** Moves the left leg sideways; positive to the left. */
    LEFT_HIP_ROLL(-11.5, 90),
    /** Turns the left leg about its length; positive to the left. */
    LEFT_HIP_YAW(-57.3, 57.3),
    /** Bends the left knee. */
    LEFT_KNEE_PITCH(0, 134.1),
    /** Tilts the left foot; positive lowers the toes. */
    LEFT_ANKLE_PITCH(-49.8, 20.1),
    /** Rolls the left foot; positive to its right. */
    LEFT_ANKLE_ROLL(-25.2, 25.2),
    /** Swings the right leg; positive backwards. */
    RIGHT_HIP_PITCH(-103.1, 90),
    /** Moves the right leg sideways; positive to the left. */
    RIGHT_HIP_ROLL(-90, 11.5),
    /** Turns the right leg about its length; positive to the left. */
    RIGHT_HIP_YAW(-57.3, 57.3),
    /** Bends the right knee. */
    RIGHT_KNEE_PITCH(0, 134.1),
    /** Tilts the right foot; positive lowers the toes. */
    RIGHT_ANKLE_PITCH(-49.8, 20.1),
    /** Rolls the right foot; positive to its right. */
    RIGHT_ANKLE_ROLL(-25.2, 25.2);

    private final double minDegrees;
    private final double maxDegrees;

    T1Joint(double minDegrees, double maxDegrees) {
        this.minDegrees = minDegrees;
        this.maxDegrees = maxDegrees;
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
     * Clamps an angle to the joint's range.
     *
     * @param degrees any angle in degrees; not NaN
     * @return the nearest angle within the range, in degrees
     */
    public double clampDegrees(double degrees) {
        return Math.max(minDegrees, Math.min(maxDegrees, degrees));
    }
}
