package org.robonewbie.simulator;

import java.util.List;
import org.robonewbie.nao.PlayMode;
import org.robonewbie.nao.Vector3;

/**
 * The true state of the world at the end of one cycle.
 *
 * @param cycle number of the cycle since the start, each 20 ms
 * @param gameTime seconds played, as in the game state perceptor
 * @param playMode what the referee has decided
 * @param teamLeft name of the left team, empty before it joined
 * @param teamRight name of the right team, empty before it joined
 * @param scoreLeft goals of the left team
 * @param scoreRight goals of the right team
 * @param half 1 or 2
 * @param ballPosition centre of the ball in the world frame, metres
 * @param ballOrientation the ball's rotation as quaternion w, x, y, z; not to be changed
 * @param robots all robots in the order in which they connected
 * @param paused whether the clock stands still
 * @param speed what was asked for with {@link SimulationControl#setSpeed}
 * @param realTimeFactor simulated seconds per second, measured over the last second
 */
@SuppressWarnings("ArrayRecordComponent")
public record WorldSnapshot(
        long cycle,
        double gameTime,
        PlayMode playMode,
        String teamLeft,
        String teamRight,
        int scoreLeft,
        int scoreRight,
        int half,
        Vector3 ballPosition,
        float[] ballOrientation,
        List<RobotSnapshot> robots,
        boolean paused,
        double speed,
        double realTimeFactor) {

    /** Length of a cycle in seconds: 0.02. */
    public static final double CYCLE_SECONDS = 0.02;

    /**
     * Tells the time since the start of the simulation.
     *
     * @return simulated seconds
     */
    public double seconds() {
        return cycle * CYCLE_SECONDS;
    }
}
