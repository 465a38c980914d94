package org.robonewbie.agent.running;

import java.util.ArrayList;
import java.util.List;

/** The robots of one program that play at the same time, each in its thread. */
public final class RobotThreads {

    private final List<Thread> threads = new ArrayList<>();

    /** Starts without a robot. */
    public RobotThreads() {}

    /**
     * Starts a robot.
     *
     * @param life what it does until it leaves the game
     */
    public void start(Runnable life) {
        Thread thread = new Thread(life);
        threads.add(thread);
        thread.start();
    }

    /** Waits until all robots have left the game. */
    public void await() {
        for (Thread thread : threads) {
            try {
                thread.join();
            } catch (InterruptedException end) {
                Thread.currentThread().interrupt();
            }
        }
    }
}
