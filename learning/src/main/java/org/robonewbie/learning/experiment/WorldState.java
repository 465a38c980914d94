package org.robonewbie.learning.experiment;

import java.util.List;
import org.robonewbie.nao.Vector3;

/**
 * The true state of the world at one moment. The world frame has its origin at the centre spot, x to the right goal, y to the
 * left of that, z up.
 *
 * @param seconds time since the trial began
 * @param robots the robots in the order of the setting
 * @param ballPosition centre of the ball, metres
 * @param ballVelocity metres per second
 */
public record WorldState(double seconds, List<RobotState> robots, Vector3 ballPosition, Vector3 ballVelocity) {

    /** Makes the list unmodifiable. */
    public WorldState {
        robots = List.copyOf(robots);
    }

    /** {@return the first robot} */
    public RobotState robot() {
        return robots.get(0);
    }
}
