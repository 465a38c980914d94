package org.robonewbie.workshop.fidelity;

import org.robonewbie.nao.Vector3;
import org.robonewbie.nao.kinematics.BodyState;
import org.robonewbie.simulator.physics.RotationMatrix;

/** Conversion between recorded torso angles and rotations. */
final class TorsoAngles {

    private TorsoAngles() {}

    /**
     * Returns the torso rotation for recorded angles.
     *
     * @param yawDegrees direction of the forward axis in the ground plane, counter-clockwise from the x axis of the world
     * @param pitchDegrees elevation of the forward axis
     * @param rollDegrees elevation of the right axis
     * @param up z component of the up axis, which distinguishes upright from upside down
     * @return the rotation from torso axes (x right, y forward, z up) to world axes
     */
    static RotationMatrix rotation(double yawDegrees, double pitchDegrees, double rollDegrees, double up) {
        double yaw = Math.toRadians(yawDegrees);
        double pitch = Math.toRadians(pitchDegrees);
        Vector3 forward =
                new Vector3(Math.cos(pitch) * Math.cos(yaw), Math.cos(pitch) * Math.sin(yaw), Math.sin(pitch));
        Vector3 levelRight = new Vector3(Math.sin(yaw), -Math.cos(yaw), 0);
        Vector3 levelUp = levelRight.cross(forward);
        double length = Math.hypot(up, Math.sin(Math.toRadians(rollDegrees)));
        double cos = length == 0 ? 1 : up / length;
        double sin = length == 0 ? 0 : Math.sin(Math.toRadians(rollDegrees)) / length;
        Vector3 right = levelRight.times(cos).plus(levelUp.times(sin));
        Vector3 top = right.cross(forward);
        return new RotationMatrix(
                right.x(), forward.x(), top.x(), right.y(), forward.y(), top.y(), right.z(), forward.z(), top.z());
    }

    /** {@return the angle between two rotations in degrees, 0 to 180} */
    static double degreesBetween(RotationMatrix one, RotationMatrix two) {
        RotationMatrix turn = one.inverse().after(two);
        Vector3 axis = new Vector3(turn.zy() - turn.yz(), turn.xz() - turn.zx(), turn.yx() - turn.xy());
        double cos = (turn.xx() + turn.yy() + turn.zz() - 1) / 2;
        return Math.toDegrees(Math.atan2(axis.length() / 2, cos));
    }

    /** {@return the direction of the forward axis in the ground plane in degrees, counter-clockwise from the x axis of the world} */
    static double yawDegrees(RotationMatrix rotation) {
        return BodyState.headingDegrees(rotation.axisY());
    }
}
