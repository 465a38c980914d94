package org.robonewbie.agent.running;

import java.lang.management.ManagementFactory;
import java.util.Optional;
import java.util.concurrent.atomic.AtomicLong;
import org.robonewbie.agent.cycle.CycleWatch;
import org.robonewbie.agent.log.Mistakes;
import org.robonewbie.agent.log.StudentCode;

/**
 * Detects that {@code think()} does not return and reports its present line, again after ten seconds if that happens again. It
 * counts its own ticks instead of looking at a clock: while a debugger holds the whole program, no time passes.
 */
public final class Watchdog implements CycleWatch, AutoCloseable {

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
    private long same = -1;
    private int ticks;
    private int allTicks;
    private boolean told;

    Watchdog(Mistakes mistakes, Optional<Runnable> giveUp) {
        this.watched = Thread.currentThread();
        this.mistakes = mistakes;
        this.giveUp = giveUp;
        thread.setDaemon(true);
    }

    /**
     * Starts a watchdog for the current thread.
     *
     * @param mistakes where it barks
     * @param giveUp what to do after five seconds of thinking; empty waits for ever
     * @return the watchdog, which watches until it is closed
     */
    public static Watchdog start(Mistakes mistakes, Optional<Runnable> giveUp) {
        Watchdog watchdog = new Watchdog(mistakes, giveUp);
        watchdog.thread.start();
        return watchdog;
    }

    @Override
    public void thinkBegins() {
        slowPlace = "";
        thought.incrementAndGet();
        thinking = true;
    }

    @Override
    public void thinkEnds() {
        thinking = false;
    }

    @Override
    public String slowPlace() {
        return slowPlace;
    }

    @Override
    public void close() {
        closed = true;
        thread.interrupt();
    }

    private void watch() {
        while (!closed) {
            try {
                Thread.sleep(TICK_MILLISECONDS);
            } catch (InterruptedException end) {
                return;
            }
            tick();
        }
    }

    /** Looks once whether the program still thinks the same thought. */
    void tick() {
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
            report("1 s; the robot waits for it");
        }
        if (giveUp.isPresent() && isStalled(ticks, TICKS_TO_GIVE_UP)) {
            report("5 s; the run ends here");
            closed = true;
            giveUp.get().run();
        }
    }

    /**
     * Whether the program itself is to blame: it waits for something, or it has really computed. On a busy computer a short
     * thought may take long as well; it gets six times as much time.
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
    private void report(String howLong) {
        String text =
                "think() has not returned for " + howLong + ". Is this an endless loop, or does it wait for something?";
        mistakes.reportAt(place(), text + allTicks / TICKS_BETWEEN_REPORTS, () -> text);
    }
}
