package org.robonewbie.agent.running;

import java.lang.management.ManagementFactory;
import java.util.Optional;
import java.util.concurrent.atomic.AtomicLong;
import java.util.function.Consumer;
import java.util.function.LongSupplier;
import org.robonewbie.agent.cycle.CycleWatch;
import org.robonewbie.agent.log.Diagnostics;

/**
 * Detects that a robot's program does not come to the end of a cycle and reports its present line, again after ten seconds if that
 * happens again; and that many cycles are slow. It counts its own ticks instead of looking at a clock: while a debugger holds the whole
 * program, no time passes.
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
    private final SlowCycles slowThoughts = new SlowCycles();
    private final AtomicLong thought = new AtomicLong();
    private volatile Thread watched = Thread.currentThread();
    private volatile boolean thinking;
    private volatile boolean closed;
    private volatile String slowPlace = "";
    private long begunNanoseconds;
    private long thoughtNanoseconds;
    private long workedNanoseconds;
    private long slowNanoseconds;
    private long same = -1;
    private int ticks;
    private int allTicks;
    private boolean told;

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
     * Starts a watchdog for the thread that turns the cycle.
     *
     * @param owner who turns the cycle
     * @param diagnostics where it barks
     * @param giveUp what to do after five seconds of thinking; empty waits for ever
     * @param listener called in the thread of the program when many cycles have been slow
     * @return the watchdog, which watches until it is closed
     */
    public static Watchdog start(
            CycleOwner owner, Diagnostics diagnostics, Optional<Runnable> giveUp, Consumer<Slowness> listener) {
        Watchdog watchdog = new Watchdog(owner, diagnostics, giveUp, listener, System::nanoTime);
        watchdog.thread.start();
        return watchdog;
    }

    @Override
    public void thinkBegins() {
        slowThoughts
                .thoughtEnds(thoughtNanoseconds / NANOSECONDS_PER_MILLISECOND)
                .ifPresent(this::report);
        thoughtNanoseconds = 0;
        slowPlace = "";
        watched = Thread.currentThread();
        thought.incrementAndGet();
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
            thoughtNanoseconds += nanoseconds.getAsLong() - begunNanoseconds;
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

    /** Looks once whether the program still thinks the same thought. */
    void tick() {
        ticks = thinking && thought.get() == same ? ticks + 1 : 0;
        same = thought.get();
        allTicks++;
        told &= ticks > 0;
        if (ticks > 0) {
            lookAtProgram();
        }
    }

    private void lookAtProgram() {
        StackSample now = StackSample.of(watched.getState(), watched.getStackTrace());
        long worked = processorNanoseconds();
        slowThoughts.sample(now, ticks == 1 ? 0 : (worked - workedNanoseconds) / NANOSECONDS_PER_MILLISECOND);
        workedNanoseconds = worked;
        if (ticks == TICKS_TO_BE_SLOW) {
            slowPlace = now.place();
            slowNanoseconds = worked;
        }
        if (!told && isStalled(TICKS_TO_REPORT, now)) {
            told = true;
            report("1 s; the robot waits for it", now);
        }
        if (giveUp.isPresent() && isStalled(TICKS_TO_GIVE_UP, now)) {
            report("5 s; the run ends here", now);
            closed = true;
            giveUp.get().run();
        }
    }

    /**
     * Whether the program itself is to blame: it waits for something, or it has really computed. On a busy computer a short
     * thought may take long as well; it gets six times as much time. A program that turns the cycle itself may wait for its user.
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

    /** Reports a stall; of the same line in the program only one in ten seconds. */
    private void report(String howLong, StackSample now) {
        String text = owner.stall(howLong);
        diagnostics.reportAt(now.place(), text + allTicks / TICKS_BETWEEN_REPORTS, () -> text);
    }

    /** Reports what makes many cycles slow, once for each line. */
    private void report(Slowness slowness) {
        StackSample cause = slowness.cause();
        diagnostics.reportAt(
                cause.place(), "slow " + cause.kind(), () -> owner.finding(slowness, "") + " " + slowness.advice());
        listener.accept(slowness);
    }
}
