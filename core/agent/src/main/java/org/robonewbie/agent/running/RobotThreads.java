package org.robonewbie.agent.running;

import java.util.ArrayList;
import java.util.List;

/** The threads of the robots that one program runs concurrently. */
public final class RobotThreads {

    private final List<Thread> threads = new ArrayList<>();

    /** Creates an empty set. */
    public RobotThreads() {}

    /**
     * Starts a thread.
     *
     * @param life runs the robot until it leaves the game
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
