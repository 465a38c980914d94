package org.robonewbie.trial;

import java.util.List;
import java.util.Optional;
import org.robonewbie.nao.Vector3;
import org.robonewbie.simulator.landscape.Landscape;
import org.robonewbie.simulator.soccer.SoccerParameters;

/**
 * The initial state of a trial: pitch and rules, robots and ball. A scene is immutable and can be reused.
 *
 * <pre>{@code
 * Scene scene = Scene.of(RobotStart.at(-3, 0)).withBall(-2.8, 0.04).withoutNoise();
 * }</pre>
 *
 * @param parameters the pitch and the referee's rules
 * @param noise whether camera readings have the league's noise
 * @param landscape objects on the pitch in addition to the goals and the ball
 * @param robots the robots in the order in which they enter the pitch
 * @param ball initial position of the ball, whose height is ignored; empty for the centre spot
 */
public record Scene(
        SoccerParameters parameters,
        boolean noise,
        Landscape landscape,
        List<RobotStart> robots,
        Optional<Vector3> ball) {

    /** Stores an unmodifiable copy of the list. */
    public Scene {
        robots = List.copyOf(robots);
        if (robots.isEmpty()) {
            throw new IllegalArgumentException("The scene has no robots. Add at least one RobotStart.");
        }
    }

    /**
     * Creates a scene on the beginners' pitch, with camera noise, and with the ball on the centre spot.
     *
     * @param robots the robots in the order in which they enter the pitch
     * @return the scene
     */
    public static Scene of(RobotStart... robots) {
        return new Scene(SoccerParameters.beginner(), true, Landscape.SOCCER, List.of(robots), Optional.empty());
    }

    /**
     * Moves the ball.
     *
     * @param x metres from the centre towards the right goal
     * @param y metres from the centre to the left
     * @return a modified copy
     */
    public Scene withBall(double x, double y) {
        return withBall(new Vector3(x, y, 0));
    }

    /**
     * Moves the ball.
     *
     * @param place its position, whose height is ignored
     * @return a modified copy
     */
    public Scene withBall(Vector3 place) {
        return new Scene(parameters, noise, landscape, robots, Optional.of(place));
    }

    /**
     * Changes the pitch and the rules.
     *
     * @param other the parameters
     * @return a modified copy
     */
    public Scene withParameters(SoccerParameters other) {
        return new Scene(other, noise, landscape, robots, ball);
    }

    /**
     * Changes the objects on the pitch.
     *
     * @param other the new landscape
     * @return a modified copy
     */
    public Scene withLandscape(Landscape other) {
        return new Scene(parameters, noise, other, robots, ball);
    }

    /**
     * Disables camera noise.
     *
     * @return a modified copy
     */
    public Scene withoutNoise() {
        return new Scene(parameters, false, landscape, robots, ball);
    }

    /**
     * Renames the team {@link RobotStart#TEAM}.
     *
     * @param name the new name
     * @return a modified copy
     */
    public Scene withTeam(String name) {
        List<RobotStart> named = robots.stream()
                .map(robot -> robot.team().equals(RobotStart.TEAM) ? robot.withTeam(name, robot.number()) : robot)
                .toList();
        return new Scene(parameters, noise, landscape, named, ball);
    }
}
