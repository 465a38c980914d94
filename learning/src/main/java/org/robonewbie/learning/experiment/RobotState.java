package org.robonewbie.learning.experiment;

import java.util.List;
import org.robonewbie.nao.BodyPart;
import org.robonewbie.nao.Joint;
import org.robonewbie.nao.Vector3;
import org.robonewbie.nao.kinematics.BodyState;
import org.robonewbie.nao.model.NaoModel;
import org.robonewbie.nao.model.RobotType;
import org.robonewbie.simulator.physics.BodyPose;

/**
 * The true state of one robot.
 *
 * @param type its robot type
 * @param links pose of each link of {@code NaoModel.of(type).links()} in the world frame; axes of a link are SimSpark's: x to
 *     the robot's right, y forward, z up
 * @param velocity velocity of the torso in the world frame, metres per second
 * @param turningDegreesPerSecond angular velocity about the torso's own axes: forward, left, up
 * @param jointDegrees angle of each joint in the order of {@link Joint}; not to be changed
 * @param jointDegreesPerSecond speed of each joint in the last cycle; not to be changed
 */
@SuppressWarnings("ArrayRecordComponent")
public record RobotState(
        RobotType type,
        List<BodyPose> links,
        Vector3 velocity,
        Vector3 turningDegreesPerSecond,
        double[] jointDegrees,
        double[] jointDegreesPerSecond) {

    /** Makes the list unmodifiable. */
    public RobotState {
        links = List.copyOf(links);
    }

    /** {@return the pose of the torso's centre in the world frame} */
    public BodyPose torso() {
        return links.get(0);
    }

    /** {@return the position of the torso's centre in the world frame, metres} */
    public Vector3 position() {
        return torso().position();
    }

    /**
     * Returns the position of a part of the body.
     *
     * @param part the part
     * @return its centre in the world frame, metres
     */
    public Vector3 position(BodyPart part) {
        return links.get(NaoModel.of(type).linkIndex(part.simSparkName())).position();
    }

    /** {@return the heading of the torso, 0 to the right goal, positive to the left, -180 to 180} */
    public double headingDegrees() {
        return BodyState.headingDegrees(torso().rotation().axisY());
    }

    /** {@return the tilt of the torso in any direction: 0 upright, 90 lying, 180 upside down} */
    public double tiltDegrees() {
        return BodyState.tiltDegrees(torso().rotation().axisZ());
    }

    /** {@return whether the robot has fallen: its torso is tilted by more than 60° or its centre is lower than 0.2 m} */
    public boolean isFallen() {
        return BodyState.isFallen(tiltDegrees(), position().z());
    }

    /**
     * Returns a joint angle.
     *
     * @param joint the joint
     * @return its angle in degrees
     */
    public double degrees(Joint joint) {
        return jointDegrees[joint.ordinal()];
    }

    /**
     * Adds up where the robot's mass is.
     *
     * @return its centre of mass in the world frame, metres
     */
    public Vector3 centreOfMass() {
        Vector3 sum = Vector3.ZERO;
        double mass = 0;
        for (int i = 0; i < links.size(); i++) {
            double kilograms = NaoModel.of(type).links().get(i).massKg();
            sum = sum.plus(links.get(i).position().times(kilograms));
            mass += kilograms;
        }
        return sum.times(1 / mass);
    }
}
