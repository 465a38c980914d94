package org.robonewbie.agent.running;

import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.atomic.AtomicInteger;
import org.robonewbie.agent.log.Diagnostics;

/** The robots of programs that turn the cycle themselves, whose {@code main} may return without a word about what went wrong. */
public final class RobotsOfProcess {

    private static final Set<Diagnostics> PRESENT = ConcurrentHashMap.newKeySet();
    private static final AtomicInteger FAILED_AND_GONE = new AtomicInteger();

    private RobotsOfProcess() {}

    /**
     * Notes a robot that has entered a game.
     *
     * @param diagnostics its mistakes
     */
    public static void enter(Diagnostics diagnostics) {
        PRESENT.add(diagnostics);
    }

    /**
     * Notes that a robot has left its game.
     *
     * @param diagnostics its mistakes
     */
    public static void leave(Diagnostics diagnostics) {
        if (PRESENT.remove(diagnostics) && diagnostics.isSerious()) {
            FAILED_AND_GONE.incrementAndGet();
        }
    }

    /** {@return how many robots could not do what their programs asked for, such as a motion that does not exist} */
    public static int failures() {
        return FAILED_AND_GONE.get()
                + (int) PRESENT.stream().filter(Diagnostics::isSerious).count();
    }
}
