package org.robonewbie.team.talk;

import org.robonewbie.nao.Cycle;

/**
 * When a robot speaks. A robot hears one message of its team in 40 ms; of two that speak at the same time one is lost. So each number
 * has a time of its own to speak, and after eleven times 40 ms it is its turn again. All robots have the same clock.
 */
public final class Talk {

    private static final int CYCLES_PER_MESSAGE = 2;
    private static final int PLAYERS = 11;

    private Talk() {}

    /**
     * Checks the clock.
     *
     * @param seconds simulated time
     * @param number the number of the robot, 1 to 11
     * @return whether it is its turn to speak
     */
    public static boolean isMyTurn(double seconds, int number) {
        long cycle = (long) Math.floor(seconds / Cycle.SECONDS + 0.5);
        return cycle % (CYCLES_PER_MESSAGE * PLAYERS) == (long) CYCLES_PER_MESSAGE * (number - 1);
    }
}
