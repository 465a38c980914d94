package org.robonewbie.simulator;

import java.util.List;
import org.robonewbie.nao.Cycle;
import org.robonewbie.nao.PlayMode;
import org.robonewbie.nao.Vector3;
import org.robonewbie.nao.kinematics.Rotation;
import org.robonewbie.simulator.landscape.Thing;

/**
 * The true state of the world at the end of one cycle.
 *
 * @param cycle number of 20 ms cycles since the start
 * @param gameTime seconds played, as in the game state perceptor
 * @param playMode the play mode
 * @param teamLeft name of the left team, empty before it joins
 * @param teamRight name of the right team, empty before it joins
 * @param scoreLeft goals of the left team
 * @param scoreRight goals of the right team
 * @param half 1 or 2
 * @param ballPosition centre of the ball in the world frame, metres
 * @param ballRotation orientation of the ball
 * @param robots all robots in the order in which they connected
 * @param things other objects on the pitch at their current poses; empty in a soccer match
 * @param paused whether the clock is paused
 * @param speed requested speed, as set with {@link org.robonewbie.protocol.order.Order.SetSpeed}
 * @param realTimeFactor simulated seconds per real second, measured over the last second
 */
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
        Rotation ballRotation,
        List<RobotSnapshot> robots,
        List<Thing> things,
        boolean paused,
        double speed,
        double realTimeFactor) {

    /**
     * Returns a copy with the given clock values.
     *
     * @param isPaused whether the clock is paused
     * @param newSpeed requested simulated seconds per real second
     * @param newFactor measured simulated seconds per real second
     * @return the copy
     */
    public WorldSnapshot withPace(boolean isPaused, double newSpeed, double newFactor) {
        return new WorldSnapshot(
                cycle,
                gameTime,
                playMode,
                teamLeft,
                teamRight,
                scoreLeft,
                scoreRight,
                half,
                ballPosition,
                ballRotation,
                robots,
                things,
                isPaused,
                newSpeed,
                newFactor);
    }

    /** {@return the simulated time since the start of the simulation in seconds} */
    public double seconds() {
        return cycle * Cycle.SECONDS;
    }
}
