package org.robonewbie.trial;

import java.util.List;
import java.util.Optional;
import org.robonewbie.nao.Vector3;
import org.robonewbie.simulator.landscape.Landscape;
import org.robonewbie.simulator.soccer.SoccerParameters;

/**
 * Where a trial begins: the pitch and its rules, the robots and the ball. A scene is a value; the same scene can be played as
 * often as you like.
 *
 * <pre>{@code
 * Scene scene = Scene.of(RobotStart.at(-3, 0)).withBall(-2.8, 0.04).withoutNoise();
 * }</pre>
 *
 * @param parameters the pitch and the referee's rules
 * @param noise whether cameras are as imprecise as those of the league
 * @param landscape what stands on the pitch besides goals and ball
 * @param robots the robots in the order in which they enter
 * @param ball where the ball lies at first, its height does not matter; empty for the centre spot
 */
public record Scene(
        SoccerParameters parameters,
        boolean noise,
        Landscape landscape,
        List<RobotStart> robots,
        Optional<Vector3> ball) {

    /** Copies the list. */
    public Scene {
        robots = List.copyOf(robots);
        if (robots.isEmpty()) {
            throw new IllegalArgumentException("A scene without robots: give at least one RobotStart.");
        }
    }

    /**
     * Creates a scene with nothing but goals and ball on the pitch.
     *
     * @param parameters the pitch and the referee's rules
     * @param noise whether cameras are as imprecise as those of the league
     * @param robots the robots in the order in which they enter
     * @param ball where the ball lies at first; empty for the centre spot
     */
    public Scene(SoccerParameters parameters, boolean noise, List<RobotStart> robots, Optional<Vector3> ball) {
        this(parameters, noise, Landscape.SOCCER, robots, ball);
    }

    /**
     * Sets a scene on the beginners' pitch, with noise and the ball on the centre spot.
     *
     * @param robots the robots in the order in which they enter
     * @return the scene
     */
    public static Scene of(RobotStart... robots) {
        return new Scene(SoccerParameters.beginner(), true, List.of(robots), Optional.empty());
    }

    /**
     * Moves the ball.
     *
     * @param x metres from the centre towards the right goal
     * @param y metres from the centre to the left
     * @return a changed copy
     */
    public Scene withBall(double x, double y) {
        return withBall(new Vector3(x, y, 0));
    }

    /**
     * Moves the ball.
     *
     * @param place where it lies; its height does not matter
     * @return a changed copy
     */
    public Scene withBall(Vector3 place) {
        return new Scene(parameters, noise, landscape, robots, Optional.of(place));
    }

    /**
     * Chooses another pitch or other rules.
     *
     * @param other the parameters
     * @return a changed copy
     */
    public Scene withParameters(SoccerParameters other) {
        return new Scene(other, noise, landscape, robots, ball);
    }

    /**
     * Puts things on the pitch.
     *
     * @param other what stands there
     * @return a changed copy
     */
    public Scene withLandscape(Landscape other) {
        return new Scene(parameters, noise, other, robots, ball);
    }

    /**
     * Removes the camera noise.
     *
     * @return a changed copy
     */
    public Scene withoutNoise() {
        return new Scene(parameters, false, landscape, robots, ball);
    }

    /**
     * Gives the robots of the team {@link RobotStart#TEAM} another name.
     *
     * @param name name of a team
     * @return a changed copy
     */
    public Scene withTeam(String name) {
        List<RobotStart> named = robots.stream()
                .map(robot -> robot.team().equals(RobotStart.TEAM) ? robot.withTeam(name, robot.number()) : robot)
                .toList();
        return new Scene(parameters, noise, landscape, named, ball);
    }
}
