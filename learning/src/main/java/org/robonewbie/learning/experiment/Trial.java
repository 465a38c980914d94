package org.robonewbie.learning.experiment;

import java.util.List;

/**
 * A world with robots under the control of one experimenter: a reset takes a seed, and each step is one cycle of 20 ms. Equal
 * seeds and equal commands give equal trials, to the bit. Not thread-safe; other threads use trials of their own.
 *
 * <pre>{@code
 * Trial trial = new SoccerTrial(TrialSetting.standing());
 * trial.reset(1);
 * double[] speeds = new double[Joint.COUNT];
 * speeds[Joint.NECK_YAW.ordinal()] = 30;
 * trial.step(speeds);
 * double degrees = trial.observation(0)[Joint.NECK_YAW.ordinal()];
 * }</pre>
 *
 * <p>What a robot is rewarded for is up to the experimenter: a function of the {@link WorldState}.
 */
public interface Trial {

    /**
     * Starts over: moves ball and robots to their places and waits until the robots rest in their first postures.
     *
     * @param seed chooses where exactly everything begins, and all noise
     */
    void reset(long seed);

    /**
     * Runs one cycle of 20 ms. As with a server, a command takes effect one cycle later than it is given.
     *
     * @param degreesPerSecond the speed of each joint for each robot, in the order of {@link org.robonewbie.nao.Joint}; clamped
     *     to what the motor can do
     * @throws IllegalArgumentException if there are not 22 speeds for each robot, or one is not a number
     */
    void step(double[]... degreesPerSecond);

    /** {@return the number of robots, at least 1} */
    int robots();

    /** {@return the true state of the world} */
    WorldState state();

    /** {@return names with units of what {@link #observation} returns, the same for each robot; unmodifiable} */
    List<ObservedQuantity> quantities();

    /**
     * Returns what a robot senses now, as its perceptors report it.
     *
     * @param robot number of the robot, from 0
     * @return one number for each of the {@link #quantities}; a new array
     */
    double[] observation(int robot);
}
