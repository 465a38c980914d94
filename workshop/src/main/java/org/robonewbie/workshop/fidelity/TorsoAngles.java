package org.robonewbie.workshop.fidelity;

import org.robonewbie.nao.Vector3;
import org.robonewbie.nao.kinematics.BodyState;
import org.robonewbie.simulator.physics.RotationMatrix;

/** Turns the angles of a recording into a rotation and back. */
final class TorsoAngles {

    private TorsoAngles() {}

    /**
     * Builds the torso's rotation.
     *
     * @param yawDegrees direction of the forward axis in the ground plane, counter-clockwise from the world's x axis
     * @param pitchDegrees rise of the forward axis above the ground
     * @param rollDegrees rise of the right axis above the ground
     * @param up z component of the up axis, which tells a robot on its feet from one on its head
     * @return the rotation from the torso's axes (x right, y forward, z up) to the world's
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

    /**
     * Calculates the angle between two rotations.
     *
     * @param one a rotation
     * @param two another one
     * @return the angle of the rotation from one to the other in degrees, 0 to 180
     */
    static double degreesBetween(RotationMatrix one, RotationMatrix two) {
        RotationMatrix turn = one.inverse().after(two);
        Vector3 axis = new Vector3(turn.zy() - turn.yz(), turn.xz() - turn.zx(), turn.yx() - turn.xy());
        double cos = (turn.xx() + turn.yy() + turn.zz() - 1) / 2;
        return Math.toDegrees(Math.atan2(axis.length() / 2, cos));
    }

    /**
     * Calculates the torso's heading.
     *
     * @param rotation the torso's rotation
     * @return degrees of its forward axis in the ground plane, counter-clockwise from the world's x axis
     */
    static double yawDegrees(RotationMatrix rotation) {
        return BodyState.headingDegrees(rotation.axisY());
    }
}
