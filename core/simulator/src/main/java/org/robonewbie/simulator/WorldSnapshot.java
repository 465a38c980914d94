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
 * @param cycle number of the cycle since the start, each 20 ms
 * @param gameTime seconds played, as in the game state perceptor
 * @param playMode what the referee has decided
 * @param teamLeft name of the left team, empty before it joined
 * @param teamRight name of the right team, empty before it joined
 * @param scoreLeft goals of the left team
 * @param scoreRight goals of the right team
 * @param half 1 or 2
 * @param ballPosition centre of the ball in the world frame, metres
 * @param ballRotation how the ball is turned
 * @param robots all robots in the order in which they connected
 * @param things what else stands on the pitch, where it is now; empty in a soccer match
 * @param paused whether the clock stands still
 * @param speed what was asked for with {@link org.robonewbie.protocol.order.Order.SetSpeed}
 * @param realTimeFactor simulated seconds per second, measured over the last second
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
     * Says how fast the world goes on.
     *
     * @param isPaused whether the clock stands still
     * @param newSpeed simulated seconds per second that were asked for
     * @param newFactor simulated seconds per second, as measured
     * @return the same state of the world at this pace
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
