package org.robonewbie.team.talk;

import org.robonewbie.nao.Cycle;

/**
 * Time-division schedule for speaking. A robot can receive one message from its team every 40 ms; if two robots speak at the
 * same time, one message is lost. So each player number has its own time slot in a period of eleven slots of 40 ms. All robots
 * have synchronised clocks.
 */
public final class Talk {

    private static final int CYCLES_PER_MESSAGE = 2;
    private static final int PLAYERS = 11;

    private Talk() {}

    /**
     * Returns whether a robot may speak.
     *
     * @param seconds simulated time
     * @param number player number, 1 to 11
     * @return whether this is its time slot
     */
    public static boolean isMyTurn(double seconds, int number) {
        long cycle = (long) Math.floor(seconds / Cycle.SECONDS + 0.5);
        return cycle % (CYCLES_PER_MESSAGE * PLAYERS) == (long) CYCLES_PER_MESSAGE * (number - 1);
    }
}
