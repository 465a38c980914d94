package org.robonewbie.agent.running;

import java.lang.management.ManagementFactory;
import java.util.Optional;
import java.util.concurrent.atomic.AtomicLong;
import java.util.function.Consumer;
import java.util.function.LongSupplier;
import org.robonewbie.agent.cycle.CycleWatch;
import org.robonewbie.agent.log.Diagnostics;

/**
 * Watchdog thread of a robot program. It reports a cycle that does not end, with the current line (at most once every
 * ten seconds for each line), and a program that is slow in many cycles. It counts its own ticks instead of reading a
 * clock, so no time passes while a debugger suspends the program.
 */
public final class Watchdog implements CycleWatch, AutoCloseable {

    private static final int TICK_MILLISECONDS = 10;
    private static final int TICKS_TO_BE_SLOW = 2;
    private static final int TICKS_TO_REPORT = 100;
    private static final int TICKS_TO_GIVE_UP = 500;
    private static final int TICKS_BETWEEN_REPORTS = 1000;
    private static final double NANOSECONDS_PER_MILLISECOND = 1e6;

    private final CycleOwner owner;
    private final Diagnostics diagnostics;
    private final Optional<Runnable> giveUp;
    private final Consumer<Slowness> listener;
    private final LongSupplier nanoseconds;
    private final Thread thread = new Thread(this::watch, "watchdog");
    private final SlowCycles slowCycles = new SlowCycles();
    private final AtomicLong cycle = new AtomicLong();
    private volatile Thread watched = Thread.currentThread();
    private volatile boolean thinking;
    private volatile boolean closed;
    private volatile String slowPlace = "";
    private long begunNanoseconds;
    private long cycleNanoseconds;
    private long workedNanoseconds;
    private long slowNanoseconds;
    private long same = -1;
    private int ticks;
    private int allTicks;
    /** Line given in the first report of the current stall and repeated in later ones; empty before the first. */
    private Optional<String> reportedPlace = Optional.empty();

    Watchdog(
            CycleOwner owner,
            Diagnostics diagnostics,
            Optional<Runnable> giveUp,
            Consumer<Slowness> listener,
            LongSupplier nanoseconds) {
        this.owner = owner;
        this.diagnostics = diagnostics;
        this.giveUp = giveUp;
        this.listener = listener;
        this.nanoseconds = nanoseconds;
        thread.setDaemon(true);
    }

    /**
     * Starts a watchdog for the thread that runs the cycle.
     *
     * @param owner owner of the cycle
     * @param diagnostics receives the reports
     * @param giveUp called after a stall of five seconds; empty to wait indefinitely
     * @param listener called in the program's thread once many cycles have been slow
     * @return the watchdog; close it to stop watching
     */
    public static Watchdog start(
            CycleOwner owner, Diagnostics diagnostics, Optional<Runnable> giveUp, Consumer<Slowness> listener) {
        Watchdog watchdog = new Watchdog(owner, diagnostics, giveUp, listener, System::nanoTime);
        watchdog.thread.start();
        return watchdog;
    }

    @Override
    public void thinkBegins() {
        slowCycles.cycleEnds(cycleNanoseconds / NANOSECONDS_PER_MILLISECOND).ifPresent(this::report);
        cycleNanoseconds = 0;
        slowPlace = "";
        watched = Thread.currentThread();
        cycle.incrementAndGet();
        thinkResumes();
    }

    @Override
    public void thinkResumes() {
        begunNanoseconds = nanoseconds.getAsLong();
        thinking = true;
    }

    @Override
    public void thinkEnds() {
        if (thinking) {
            thinking = false;
            cycleNanoseconds += nanoseconds.getAsLong() - begunNanoseconds;
        }
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

    /** Checks once whether the program is still in the same cycle. */
    void tick() {
        ticks = thinking && cycle.get() == same ? ticks + 1 : 0;
        same = cycle.get();
        allTicks++;
        if (ticks > 0) {
            sampleProgram();
        } else {
            reportedPlace = Optional.empty();
        }
    }

    private void sampleProgram() {
        StackSample now = StackSample.of(watched.getState(), watched.getStackTrace());
        long worked = processorNanoseconds();
        slowCycles.sample(now, ticks == 1 ? 0 : (worked - workedNanoseconds) / NANOSECONDS_PER_MILLISECOND);
        workedNanoseconds = worked;
        if (ticks == TICKS_TO_BE_SLOW) {
            slowPlace = now.place();
            slowNanoseconds = worked;
        }
        if (reportedPlace.isEmpty() && isStalled(TICKS_TO_REPORT, now)) {
            reportedPlace = Optional.of(now.place());
            report("1 s; the robot waits for it", now.place());
        }
        if (giveUp.isPresent() && isStalled(TICKS_TO_GIVE_UP, now)) {
            report("5 s; the run ends here", reportedPlace.orElse(now.place()));
            closed = true;
            giveUp.get().run();
        }
    }

    /**
     * Returns whether the program itself has stalled: it is waiting for something, or it has used processor time. On a
     * busy computer even a short cycle may take a long time, so a program that has used little processor time is given
     * six times the usual limit. A program that runs the cycle itself may wait for user input.
     */
    private boolean isStalled(int patience, StackSample now) {
        if (ticks < patience) {
            return false;
        }
        double computed = (processorNanoseconds() - slowNanoseconds) / NANOSECONDS_PER_MILLISECOND;
        boolean sleeps = now.kind() == StackSample.Kind.SLEEPS;
        boolean waits = sleeps || watched.getState() != Thread.State.RUNNABLE || ticks >= 6 * patience;
        return computed >= patience * TICK_MILLISECONDS / 5.0 || (owner == CycleOwner.FRAMEWORK ? waits : sleeps);
    }

    private long processorNanoseconds() {
        return ManagementFactory.getThreadMXBean().getThreadCpuTime(watched.getId());
    }

    /** Reports a stall, at most once every ten seconds for each line. */
    private void report(String howLong, String place) {
        String text = owner.stall(howLong);
        diagnostics.reportAt(place, text + allTicks / TICKS_BETWEEN_REPORTS, () -> text);
    }

    /** Reports the cause of slow cycles, once for each line of the program. */
    private void report(Slowness slowness) {
        StackSample cause = slowness.cause();
        diagnostics.reportAt(
                cause.place(), "slow " + cause.kind(), () -> owner.finding(slowness, "") + " " + slowness.advice());
        listener.accept(slowness);
    }
}
