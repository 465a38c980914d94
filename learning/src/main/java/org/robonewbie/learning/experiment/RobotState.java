package org.robonewbie.learning.experiment;

import java.util.List;
import org.robonewbie.nao.BodyPart;
import org.robonewbie.nao.Joint;
import org.robonewbie.nao.Vector3;
import org.robonewbie.nao.model.NaoModel;
import org.robonewbie.nao.model.RobotType;
import org.robonewbie.simulator.physics.Pose;

/**
 * The true state of one robot.
 *
 * @param type its build
 * @param links pose of each link of {@code NaoModel.of(type).links()} in the world frame; axes of a link are SimSpark's: x to
 *     the robot's right, y forward, z up
 * @param velocity speed of the torso in the world frame, metres per second
 * @param turningDegreesPerSecond speed about the torso's own axes: forward, left, up
 * @param jointDegrees angle of each joint in the order of {@link Joint}; not to be changed
 * @param jointDegreesPerSecond how fast each joint turned in the last cycle; not to be changed
 */
@SuppressWarnings("ArrayRecordComponent")
public record RobotState(
        RobotType type,
        List<Pose> links,
        Vector3 velocity,
        Vector3 turningDegreesPerSecond,
        double[] jointDegrees,
        double[] jointDegreesPerSecond) {

    /** Tilt of the torso beyond which a robot counts as fallen, degrees. */
    public static final double FALLEN_DEGREES = 60;

    /** Height of the torso's centre below which a robot counts as fallen, metres. */
    public static final double FALLEN_METRES = 0.2;

    /** Makes the list unmodifiable. */
    public RobotState {
        links = List.copyOf(links);
    }

    /**
     * Tells where the torso is.
     *
     * @return pose of its centre in the world frame
     */
    public Pose torso() {
        return links.get(0);
    }

    /**
     * Tells where the robot is.
     *
     * @return centre of the torso in the world frame, metres
     */
    public Vector3 position() {
        return torso().position();
    }

    /**
     * Tells where a part of the body is.
     *
     * @param part the part
     * @return its centre in the world frame, metres
     */
    public Vector3 position(BodyPart part) {
        return links.get(NaoModel.of(type).linkIndex(part.simSparkName())).position();
    }

    /**
     * Tells where the robot looks.
     *
     * @return direction of the torso's forward axis, 0 to the right goal, positive to the left, -180 to 180
     */
    public double headingDegrees() {
        Vector3 forward = torso().rotation().apply(new Vector3(0, 1, 0));
        return Math.toDegrees(Math.atan2(forward.y(), forward.x()));
    }

    /**
     * Tells how far the torso leans to any side.
     *
     * @return 0 upright, 90 lying, 180 upside down
     */
    public double tiltDegrees() {
        double up = torso().rotation().apply(new Vector3(0, 0, 1)).z();
        return Math.toDegrees(Math.acos(Math.max(-1, Math.min(1, up))));
    }

    /**
     * Tells whether the robot lies, falls or has broken down.
     *
     * @return whether the torso leans by more than 60° or its centre is lower than 0.2 m
     */
    public boolean isFallen() {
        return tiltDegrees() > FALLEN_DEGREES || position().z() < FALLEN_METRES;
    }

    /**
     * Tells where a joint is.
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
