package org.robonewbie.nao.motion;

import org.robonewbie.nao.Joint;
import org.robonewbie.nao.Vector3;
import org.robonewbie.nao.model.NaoModel;
import org.robonewbie.nao.model.RobotType;

/**
 * Reflection of joint angles in the robot's sagittal plane, which exchanges left and right.
 *
 * <p>A reflection turns a rotation about an axis into the opposite rotation about the reflected axis. The angle therefore changes
 * its sign where the partner joint's axis in {@link NaoModel} equals the reflected axis, and keeps it where the partner's axis
 * points the other way.
 */
public final class Mirror {

    private static final Joint[] PARTNERS = new Joint[Joint.COUNT];
    private static final boolean[] CHANGES_SIGN = new boolean[Joint.COUNT];

    static {
        NaoModel model = NaoModel.of(RobotType.TYPE_0);
        for (Joint joint : Joint.values()) {
            Joint partner = findPartner(joint);
            Vector3 axis = axis(model, joint);
            Vector3 mirroredAxis = new Vector3(-axis.x(), axis.y(), axis.z());
            PARTNERS[joint.ordinal()] = partner;
            CHANGES_SIGN[joint.ordinal()] = mirroredAxis.dot(axis(model, partner)) > 0;
        }
    }

    private Mirror() {}

    /**
     * Returns the corresponding joint on the other side.
     *
     * @param joint a joint
     * @return the same joint of the other arm or leg; for a joint of the neck, the joint itself
     */
    public static Joint partner(Joint joint) {
        return PARTNERS[joint.ordinal()];
    }

    /**
     * Returns the mirrored angle.
     *
     * @param joint a joint
     * @param degrees its angle in degrees
     * @return the angle of {@link #partner} in degrees
     */
    public static double mirroredDegrees(Joint joint, double degrees) {
        return CHANGES_SIGN[joint.ordinal()] ? -degrees : degrees;
    }

    private static Joint findPartner(Joint joint) {
        String name = joint.name();
        if (name.startsWith("LEFT_")) {
            return Joint.valueOf(name.replace("LEFT_", "RIGHT_"));
        }
        return name.startsWith("RIGHT_") ? Joint.valueOf(name.replace("RIGHT_", "LEFT_")) : joint;
    }

    private static Vector3 axis(NaoModel model, Joint joint) {
        return model.hinges().get(model.hingeIndex(joint)).axis();
    }
}
