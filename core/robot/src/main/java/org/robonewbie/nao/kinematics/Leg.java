package org.robonewbie.nao.kinematics;

import java.util.List;
import org.robonewbie.nao.Joint;
import org.robonewbie.nao.motion.Mirror;

/** One of the two legs. */
public enum Leg {
    /** The left leg. */
    LEFT("l"),
    /** The right leg. */
    RIGHT("r");

    private static final List<Joint> LEFT_JOINTS = List.of(
            Joint.LEFT_HIP_YAW_PITCH,
            Joint.LEFT_HIP_ROLL,
            Joint.LEFT_HIP_PITCH,
            Joint.LEFT_KNEE_PITCH,
            Joint.LEFT_FOOT_PITCH,
            Joint.LEFT_FOOT_ROLL);
    private static final List<Joint> RIGHT_JOINTS =
            LEFT_JOINTS.stream().map(Mirror::partner).toList();

    private final String footLink;

    Leg(String prefix) {
        footLink = prefix + "foot";
    }

    /** {@return the leg's joints from hip to foot: hip yaw-pitch, hip roll, hip pitch, knee pitch, foot pitch, foot roll} */
    public List<Joint> joints() {
        return this == LEFT ? LEFT_JOINTS : RIGHT_JOINTS;
    }

    /** {@return the name of the foot's link in {@link org.robonewbie.nao.model.NaoModel}} */
    public String footLink() {
        return footLink;
    }

    /** {@return the leg on the other side} */
    public Leg other() {
        return this == LEFT ? RIGHT : LEFT;
    }
}
