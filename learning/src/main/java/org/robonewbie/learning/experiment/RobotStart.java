package org.robonewbie.learning.experiment;

import org.robonewbie.agent.walk.Stance;
import org.robonewbie.nao.model.RobotType;
import org.robonewbie.nao.motion.Posture;

/**
 * Where a robot begins.
 *
 * @param type its build
 * @param xMetres place along the world's x axis, which leads to the right goal
 * @param yMetres place to the left of that axis
 * @param headingDegrees where it looks, 0 to the right goal, positive to the left
 * @param posture its first posture, on its feet
 */
public record RobotStart(RobotType type, double xMetres, double yMetres, double headingDegrees, Posture posture) {

    /**
     * Places a standard robot in the stance, looking to the right goal.
     *
     * @param xMetres place along the world's x axis
     * @param yMetres place to the left of that axis
     * @return the start
     */
    public static RobotStart at(double xMetres, double yMetres) {
        return new RobotStart(RobotType.TYPE_0, xMetres, yMetres, 0, Stance.POSTURE);
    }

    /**
     * Chooses another first posture.
     *
     * @param other a posture in which the robot can stand
     * @return a changed copy
     */
    public RobotStart in(Posture other) {
        return new RobotStart(type, xMetres, yMetres, headingDegrees, other);
    }

    /**
     * Chooses another direction.
     *
     * @param degrees where it looks, 0 to the right goal, positive to the left
     * @return a changed copy
     */
    public RobotStart facing(double degrees) {
        return new RobotStart(type, xMetres, yMetres, degrees, posture);
    }
}
