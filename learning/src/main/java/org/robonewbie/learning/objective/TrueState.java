package org.robonewbie.learning.objective;

import org.robonewbie.nao.Vector3;
import org.robonewbie.nao.kinematics.BodyState;
import org.robonewbie.nao.motion.Posture;

/**
 * The true state of one robot and the ball after a cycle, without noise and delay. Positions and velocities are in the world
 * frame, in metres and metres per second; the robot plays towards the goal at the right end unless configured otherwise.
 *
 * @param seconds simulated time since the observation began
 * @param torso centre of the torso
 * @param velocity velocity of the torso
 * @param headingDegrees heading of the torso, -180 to 180, 0 along the world's x axis, positive to the left
 * @param uprightness cosine of the torso's tilt: 1 upright, 0 lying, -1 upside down
 * @param turning angular velocity of the torso about its own axes, degrees per second
 * @param joints the angles of all joints
 * @param workJoules energy that its motors have put into lifting and moving its limbs so far
 * @param ball centre of the ball
 * @param ballVelocity velocity of the ball
 * @param ballToGoal metres from the ball to the line of the opponents' goal, 0 when it is in
 * @param isScored whether the ball is in the opponents' goal or has been there before
 */
public record TrueState(
        double seconds,
        Vector3 torso,
        Vector3 velocity,
        double headingDegrees,
        double uprightness,
        Vector3 turning,
        Posture joints,
        double workJoules,
        Vector3 ball,
        Vector3 ballVelocity,
        double ballToGoal,
        boolean isScored) {

    /** {@return whether the robot has fallen: its torso is tilted by more than 60° or its centre is lower than 0.2 m} */
    public boolean isFallen() {
        return BodyState.isFallen(tiltDegrees(), torso.z());
    }

    /** {@return the tilt of the torso in degrees from the vertical, 0 to 180} */
    public double tiltDegrees() {
        return Math.toDegrees(Math.acos(Math.max(-1, Math.min(1, uprightness))));
    }

    /**
     * Returns the distance of a point ahead of the robot.
     *
     * @param place a point in the world frame
     * @return metres along the robot's heading, negative behind it
     */
    public double ahead(Vector3 place) {
        double radians = Math.toRadians(headingDegrees);
        Vector3 way = place.minus(torso);
        return Math.cos(radians) * way.x() + Math.sin(radians) * way.y();
    }

    /**
     * Returns the distance of a point to the left of the robot.
     *
     * @param place a point in the world frame
     * @return metres across the robot's heading, negative to the right
     */
    public double left(Vector3 place) {
        double radians = Math.toRadians(headingDegrees);
        Vector3 way = place.minus(torso);
        return -Math.sin(radians) * way.x() + Math.cos(radians) * way.y();
    }
}
