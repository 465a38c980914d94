package org.robonewbie.learning.experiment;

import java.util.List;

/**
 * A world with robots in the hand of one experimenter: it begins anew with a seed, and each step is one cycle of 20 ms.
 * Equal seeds and equal commands give equal trials, to the bit. One thread at a time; other threads use trials of their own.
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
 * <p>What a robot is paid for is the experimenter's own affair: a function of the {@link WorldState}.
 */
public interface Trial {

    /**
     * Begins anew: puts ball and robots to their places and lets the robots come to rest in their first postures.
     *
     * @param seed chooses where exactly everything begins, and all noise
     */
    void reset(long seed);

    /**
     * Lets one cycle of 20 ms pass. As with a server, a command acts one cycle later than it is given.
     *
     * @param degreesPerSecond the speed of each joint for each robot, in the order of {@link org.robonewbie.nao.Joint};
     *     cut to what the motor can do
     * @throws IllegalArgumentException if there are not 22 speeds for each robot, or one is not a number
     */
    void step(double[]... degreesPerSecond);

    /**
     * Tells how many robots there are.
     *
     * @return at least 1
     */
    int robots();

    /**
     * Tells what is true now.
     *
     * @return the world as a referee with perfect eyes sees it
     */
    WorldState state();

    /**
     * Names what {@link #observation} gives, the same for each robot.
     *
     * @return names with units, unmodifiable
     */
    List<ObservedQuantity> quantities();

    /**
     * Tells what a robot feels and sees now, as its perceptors report it.
     *
     * @param robot number of the robot, from 0
     * @return one number for each of the {@link #quantities}; a new array
     */
    double[] observation(int robot);
}
