package org.robonewbie.agent.league;

import java.util.ArrayList;
import java.util.List;
import org.robonewbie.nao.Joint;
import org.robonewbie.robot.RobotModel;

/**
 * A joint of arms or head that a robot of the league has in common with the NAO: angle of the robot = sign · angle of the NAO + offset.
 *
 * <p>At 0° the NAO's arms point forward and those of the league's robots to the side; with this conversion, upper arm and forearm point
 * in the same directions.
 *
 * @param joint the joint of the NAO
 * @param index index of the joint in the robot's model
 * @param sign 1, or -1 if the robot's joint turns the other way
 * @param offset angle of the robot's joint in degrees when the NAO's is at 0°
 */
record SharedJoint(Joint joint, int index, int sign, double offset) {

    /** Returns all joints that a robot has in common with the NAO. */
    static List<SharedJoint> of(RobotModel model) {
        List<SharedJoint> shared = new ArrayList<>();
        add(model, shared, Joint.NECK_YAW, 1, 0);
        add(model, shared, Joint.NECK_PITCH, -1, 0);
        add(model, shared, Joint.LEFT_SHOULDER_PITCH, -1, -90);
        add(model, shared, Joint.LEFT_SHOULDER_YAW, 1, -90);
        add(model, shared, Joint.LEFT_ARM_ROLL, 1, 90);
        add(model, shared, Joint.LEFT_ARM_YAW, 1, 0);
        add(model, shared, Joint.RIGHT_SHOULDER_PITCH, -1, -90);
        add(model, shared, Joint.RIGHT_SHOULDER_YAW, 1, 90);
        add(model, shared, Joint.RIGHT_ARM_ROLL, -1, 90);
        add(model, shared, Joint.RIGHT_ARM_YAW, 1, 0);
        return List.copyOf(shared);
    }

    private static void add(RobotModel model, List<SharedJoint> shared, Joint joint, int sign, double offset) {
        model.joint(joint.effectorName())
                .ifPresent(own -> shared.add(new SharedJoint(joint, own.index(), sign, offset)));
    }

    boolean isArm() {
        return joint != Joint.NECK_YAW && joint != Joint.NECK_PITCH;
    }

    /** Converts an angle of the NAO's joint, in degrees. */
    double fromNao(double degrees) {
        return sign * degrees + offset;
    }

    /** Converts an angle of the robot's joint, in degrees. */
    double toNao(double degrees) {
        return sign * (degrees - offset);
    }
}
