package org.robonewbie.agent.running;

import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.atomic.AtomicInteger;
import org.robonewbie.agent.log.Diagnostics;

/**
 * Registry of the robots whose programs run the cycle themselves. It counts those with serious errors, because {@code
 * main} may return normally despite errors.
 */
public final class RobotsOfProcess {

    private static final Set<Diagnostics> PRESENT = ConcurrentHashMap.newKeySet();
    private static final AtomicInteger FAILED_AND_GONE = new AtomicInteger();

    private RobotsOfProcess() {}

    /**
     * Registers a robot that has joined a game.
     *
     * @param diagnostics its diagnostics
     */
    public static void enter(Diagnostics diagnostics) {
        PRESENT.add(diagnostics);
    }

    /**
     * Unregisters a robot that has left its game.
     *
     * @param diagnostics its diagnostics
     */
    public static void leave(Diagnostics diagnostics) {
        if (PRESENT.remove(diagnostics) && diagnostics.isSerious()) {
            FAILED_AND_GONE.incrementAndGet();
        }
    }

    /** {@return the number of robots with serious errors, such as a motion that does not exist} */
    public static int failures() {
        return FAILED_AND_GONE.get()
                + (int) PRESENT.stream().filter(Diagnostics::isSerious).count();
    }
}
