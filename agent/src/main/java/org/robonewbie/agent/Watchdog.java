package org.robonewbie.agent;

import java.util.Optional;
import java.util.concurrent.atomic.AtomicLong;
import org.robonewbie.agent.log.Mistakes;
import org.robonewbie.agent.log.StudentCode;

/**
 * Notices that {@code think()} does not return and says in which line it is, again after ten seconds if that happens again. It
 * counts its own ticks instead of looking at a clock: while a debugger holds the whole program, no time passes.
 */
final class Watchdog implements AutoCloseable {

    private static final int TICK_MILLISECONDS = 10;
    private static final int TICKS_TO_BE_SLOW = 2;
    private static final int TICKS_TO_REPORT = 100;
    private static final int TICKS_TO_GIVE_UP = 500;
    private static final int TICKS_BETWEEN_REPORTS = 1000;

    private final Thread watched;
    private final Mistakes mistakes;
    private final Optional<Runnable> giveUp;
    private final Thread thread = new Thread(this::watch, "watchdog");
    private final AtomicLong thought = new AtomicLong();
    private volatile boolean thinking;
    private volatile boolean closed;
    private volatile String slowPlace = "";

    /**
     * Creates a watchdog for the current thread.
     *
     * @param mistakes where it barks
     * @param giveUp what to do after five seconds of thinking; empty waits for ever
     */
    Watchdog(Mistakes mistakes, Optional<Runnable> giveUp) {
        this.watched = Thread.currentThread();
        this.mistakes = mistakes;
        this.giveUp = giveUp;
        thread.setDaemon(true);
        thread.start();
    }

    void thinkBegins() {
        slowPlace = "";
        thought.incrementAndGet();
        thinking = true;
    }

    void thinkEnds() {
        thinking = false;
    }

    /** Where think() was last seen after it had taken a whole cycle; empty if it was quicker. */
    String slowPlace() {
        return slowPlace;
    }

    @Override
    public void close() {
        closed = true;
        thread.interrupt();
    }

    private void watch() {
        long same = -1;
        int ticks = 0;
        int allTicks = 0;
        while (!closed) {
            try {
                Thread.sleep(TICK_MILLISECONDS);
            } catch (InterruptedException end) {
                return;
            }
            ticks = thinking && thought.get() == same ? ticks + 1 : 0;
            same = thought.get();
            allTicks++;
            if (ticks == TICKS_TO_BE_SLOW) {
                slowPlace = place();
            }
            if (ticks == TICKS_TO_REPORT) {
                report(
                        allTicks / TICKS_BETWEEN_REPORTS,
                        "think() has not returned for 1 s; the robot waits for it. Is this an endless loop, or does it wait for something?");
            }
            if (ticks == TICKS_TO_GIVE_UP && giveUp.isPresent()) {
                report(
                        allTicks / TICKS_BETWEEN_REPORTS,
                        "think() has not returned for 5 s; the run ends here. Is this an endless loop, or does it wait for something?");
                giveUp.get().run();
                return;
            }
        }
    }

    private String place() {
        return StudentCode.place(watched.getStackTrace()).orElse("");
    }

    /** Reports a stall; of the same line in the program only one in ten seconds. */
    private void report(int period, String text) {
        mistakes.reportAt(place(), text + period, () -> text);
    }
}
