package org.robonewbie.studio;

import java.util.EnumMap;
import java.util.Map;
import org.robonewbie.nao.Joint;

/** Stable posture for the robots of the tests. */
final class Posture {

    /** Slightly bent knees, arms hanging. */
    static final Map<Joint, Double> STANDING = standing();

    private Posture() {}

    private static Map<Joint, Double> standing() {
        Map<Joint, Double> degrees = new EnumMap<>(Joint.class);
        degrees.put(Joint.LEFT_SHOULDER_PITCH, -78.0);
        degrees.put(Joint.RIGHT_SHOULDER_PITCH, -78.0);
        degrees.put(Joint.LEFT_SHOULDER_YAW, 12.0);
        degrees.put(Joint.RIGHT_SHOULDER_YAW, -12.0);
        degrees.put(Joint.LEFT_ARM_ROLL, -85.0);
        degrees.put(Joint.RIGHT_ARM_ROLL, 85.0);
        degrees.put(Joint.LEFT_ARM_YAW, -38.0);
        degrees.put(Joint.RIGHT_ARM_YAW, 38.0);
        degrees.put(Joint.LEFT_HIP_PITCH, 30.0);
        degrees.put(Joint.RIGHT_HIP_PITCH, 30.0);
        degrees.put(Joint.LEFT_KNEE_PITCH, -58.0);
        degrees.put(Joint.RIGHT_KNEE_PITCH, -58.0);
        degrees.put(Joint.LEFT_FOOT_PITCH, 28.0);
        degrees.put(Joint.RIGHT_FOOT_PITCH, 28.0);
        return degrees;
    }
}
