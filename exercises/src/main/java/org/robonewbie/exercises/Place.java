package org.robonewbie.exercises;

import org.robonewbie.nao.Vector3;

/**
 * Where a robot stands on the pitch and where it looks to.
 *
 * @param x metres from the centre towards the right goal
 * @param y metres from the centre to the left, as seen by who looks to the right goal
 * @param degrees direction: 0 looks to the right goal, positive is left
 */
public record Place(double x, double y, double degrees) {

    /**
     * Finds a point as seen from here.
     *
     * @param distance metres from here
     * @param bearing degrees to the left of where the robot looks
     * @param height metres above the ground
     * @return the point on the pitch
     */
    public Vector3 point(double distance, double bearing, double height) {
        double angle = Math.toRadians(degrees + bearing);
        return new Vector3(x + distance * Math.cos(angle), y + distance * Math.sin(angle), height);
    }
}
