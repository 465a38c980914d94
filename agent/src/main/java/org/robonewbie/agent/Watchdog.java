package org.robonewbie.agent;

import java.lang.management.ManagementFactory;
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
    private long slowMilliseconds;

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
        boolean told = false;
        while (!closed) {
            try {
                Thread.sleep(TICK_MILLISECONDS);
            } catch (InterruptedException end) {
                return;
            }
            ticks = thinking && thought.get() == same ? ticks + 1 : 0;
            same = thought.get();
            allTicks++;
            told &= ticks > 0;
            if (ticks == TICKS_TO_BE_SLOW) {
                slowPlace = place();
                slowMilliseconds = processorMilliseconds();
            }
            if (!told && isStalled(ticks, TICKS_TO_REPORT)) {
                told = true;
                report(
                        allTicks / TICKS_BETWEEN_REPORTS,
                        "think() has not returned for 1 s; the robot waits for it. Is this an endless loop, or does it wait for something?");
            }
            if (giveUp.isPresent() && isStalled(ticks, TICKS_TO_GIVE_UP)) {
                report(
                        allTicks / TICKS_BETWEEN_REPORTS,
                        "think() has not returned for 5 s; the run ends here. Is this an endless loop, or does it wait for something?");
                giveUp.get().run();
                return;
            }
        }
    }

    /**
     * Whether the time has passed by the program's own fault: it waits for something, or it has really computed. On a busy computer a
     * short thought may take long as well; it gets six times as much time.
     */
    private boolean isStalled(int ticks, int patience) {
        if (ticks < patience) {
            return false;
        }
        boolean waits = watched.getState() != Thread.State.RUNNABLE;
        long computed = processorMilliseconds() - slowMilliseconds;
        return waits || computed >= patience * TICK_MILLISECONDS / 5 || ticks >= 6 * patience;
    }

    private long processorMilliseconds() {
        return ManagementFactory.getThreadMXBean().getThreadCpuTime(watched.getId()) / 1_000_000;
    }

    private String place() {
        return StudentCode.place(watched.getStackTrace()).orElse("");
    }

    /** Reports a stall; of the same line in the program only one in ten seconds. */
    private void report(int period, String text) {
        mistakes.reportAt(place(), text + period, () -> text);
    }
}
