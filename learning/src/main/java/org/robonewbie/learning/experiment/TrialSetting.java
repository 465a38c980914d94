package org.robonewbie.learning.experiment;

import java.util.List;
import org.robonewbie.nao.SoccerField;
import org.robonewbie.nao.Vector3;

/**
 * How trials begin and what their robots perceive.
 *
 * <pre>{@code
 * TrialSetting penalty = TrialSetting.standing()
 *         .withRobots(List.of(RobotStart.at(4, 0), RobotStart.at(5.5, 0).facing(180)))
 *         .withBall(new Vector3(4.2, -0.05, 0.042));
 * }</pre>
 *
 * @param field dimensions of the pitch
 * @param robots where the robots begin, at least one
 * @param ball centre of the ball in the world frame, metres
 * @param placeSpreadMetres how much the places of robots and ball vary along each axis
 * @param headingSpreadDegrees how much the robots' headings vary to either side
 * @param jointSpreadDegrees how much the joint angles vary
 * @param cameraNoise whether the cameras are as imprecise as the server's
 * @param camera whether robots have cameras at all; without them a trial is faster
 * @param settlingSeconds time to come to rest in the first posture
 */
public record TrialSetting(
        SoccerField field,
        List<RobotStart> robots,
        Vector3 ball,
        double placeSpreadMetres,
        double headingSpreadDegrees,
        double jointSpreadDegrees,
        boolean cameraNoise,
        boolean camera,
        double settlingSeconds) {

    /** Copies the list. */
    public TrialSetting {
        robots = List.copyOf(robots);
        if (robots.isEmpty()) {
            throw new IllegalArgumentException("A trial without robots: give at least one RobotStart.");
        }
    }

    /**
     * Describes one robot that stands on the beginners' pitch and looks to the goal 4.5 m ahead, with the ball 1 m before it;
     * joints differ by up to 1° from trial to trial.
     *
     * @return the setting
     */
    public static TrialSetting standing() {
        return new TrialSetting(
                SoccerField.BEGINNER,
                List.of(RobotStart.at(1.5, 0)),
                new Vector3(2.5, 0, 0.042),
                0,
                0,
                1,
                true,
                true,
                1);
    }

    /**
     * Chooses other robots.
     *
     * @param others where they begin, at least one
     * @return a changed copy
     */
    public TrialSetting withRobots(List<RobotStart> others) {
        return new TrialSetting(
                field,
                others,
                ball,
                placeSpreadMetres,
                headingSpreadDegrees,
                jointSpreadDegrees,
                cameraNoise,
                camera,
                settlingSeconds);
    }

    /**
     * Moves the ball.
     *
     * @param position its centre in the world frame, metres
     * @return a changed copy
     */
    public TrialSetting withBall(Vector3 position) {
        return new TrialSetting(
                field,
                robots,
                position,
                placeSpreadMetres,
                headingSpreadDegrees,
                jointSpreadDegrees,
                cameraNoise,
                camera,
                settlingSeconds);
    }

    /**
     * Sets how much trials differ.
     *
     * @param placeMetres how much the places of robots and ball vary along each axis
     * @param headingDegrees how much the robots' headings vary to either side
     * @param jointDegrees how much the joint angles vary
     * @return a changed copy
     */
    public TrialSetting withSpread(double placeMetres, double headingDegrees, double jointDegrees) {
        return new TrialSetting(
                field, robots, ball, placeMetres, headingDegrees, jointDegrees, cameraNoise, camera, settlingSeconds);
    }

    /**
     * Takes the cameras away; the ball is not observed then.
     *
     * @return a changed copy
     */
    public TrialSetting withoutCamera() {
        return new TrialSetting(
                field,
                robots,
                ball,
                placeSpreadMetres,
                headingSpreadDegrees,
                jointSpreadDegrees,
                cameraNoise,
                false,
                settlingSeconds);
    }

    /**
     * Chooses how long robots have to come to rest.
     *
     * @param seconds the time before a trial begins; with 0 robots begin with all joints at 0
     * @return a changed copy
     */
    public TrialSetting withSettling(double seconds) {
        return new TrialSetting(
                field,
                robots,
                ball,
                placeSpreadMetres,
                headingSpreadDegrees,
                jointSpreadDegrees,
                cameraNoise,
                camera,
                seconds);
    }
}
