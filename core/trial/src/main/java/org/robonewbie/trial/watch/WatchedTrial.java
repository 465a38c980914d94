package org.robonewbie.trial.watch;

import java.util.List;
import java.util.Optional;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.locks.Condition;
import java.util.concurrent.locks.ReentrantLock;
import org.robonewbie.nao.Cycle;
import org.robonewbie.nao.SoccerField;
import org.robonewbie.protocol.order.Order;
import org.robonewbie.simulator.SimulationControl;
import org.robonewbie.simulator.SimulationObserver;
import org.robonewbie.simulator.TrialLabel;
import org.robonewbie.simulator.WorldSnapshot;
import org.robonewbie.trial.Trial;
import org.robonewbie.trial.TrialListener;

/** A real-time view of a trial that can be paused. The user cannot move the ball or the robots, because the trial is being graded. */
public final class WatchedTrial implements SimulationControl, TrialListener {

    private static final long REPORT_MILLISECONDS = 100;
    private static final double MIN_SPEED = 0.1;
    private static final long MAX_DELAY_NANOS = TimeUnit.MILLISECONDS.toNanos(200);

    private final Optional<TrialLabel> label;
    private final List<SimulationObserver> observers = new CopyOnWriteArrayList<>();
    private final ReentrantLock lock = new ReentrantLock();
    private final Condition changed = lock.newCondition();
    private double speed = 1;
    private boolean paused;
    private boolean over;
    private int steps;
    private long nextCycleNanos;
    private Optional<WorldSnapshot> last = Optional.empty();

    /** Creates the view of a trial that has not started. */
    public WatchedTrial() {
        this(Optional.empty());
    }

    private WatchedTrial(Optional<TrialLabel> label) {
        this.label = label;
    }

    /**
     * Creates the view of the next trial, with the same playback speed as this view.
     *
     * @param name identity of the next trial
     * @return the view of a trial that has not started
     */
    public WatchedTrial next(TrialLabel name) {
        WatchedTrial next = new WatchedTrial(Optional.of(name));
        change(() -> next.speed = speed);
        return next;
    }

    /** Detaches the view; the trial then runs to its end without waiting. The last snapshot remains visible. */
    public void leave() {
        change(() -> over = true);
        reportStopped();
    }

    private void reportStopped() {
        change(() -> last = last.map(snapshot -> snapshot.withPace(true, speed, snapshot.realTimeFactor())));
        last.ifPresent(snapshot -> observers.forEach(observer -> observer.cycleEnded(snapshot)));
    }

    @Override
    public void cycleEnded(Trial trial) {
        lock.lock();
        try {
            steps = Math.max(0, steps - 1);
            if (!over) {
                report(trial);
                keepPace(trial);
            }
        } catch (InterruptedException stop) {
            over = true;
            Thread.currentThread().interrupt();
        } finally {
            lock.unlock();
        }
    }

    private void report(Trial trial) {
        WorldSnapshot snapshot = trial.snapshot(isPaused(), speed);
        last = Optional.of(snapshot);
        observers.forEach(observer -> observer.cycleEnded(snapshot));
    }

    private boolean isPaused() {
        return paused && steps == 0;
    }

    private void keepPace(Trial trial) throws InterruptedException {
        while (isPaused() && !over) {
            boolean signalled = changed.await(REPORT_MILLISECONDS, TimeUnit.MILLISECONDS);
            if (!signalled) {
                report(trial);
            }
        }
        if (speed == AS_FAST_AS_POSSIBLE) {
            return;
        }
        long now = System.nanoTime();
        nextCycleNanos = Math.max(nextCycleNanos + (long) (Cycle.SECONDS / speed * 1e9), now - MAX_DELAY_NANOS);
        for (long rest = nextCycleNanos - now;
                rest > 0 && !over && !paused;
                rest = nextCycleNanos - System.nanoTime()) {
            changed.awaitNanos(rest);
        }
    }

    private void change(Runnable action) {
        lock.lock();
        try {
            action.run();
            nextCycleNanos = System.nanoTime();
            changed.signalAll();
        } finally {
            lock.unlock();
        }
    }

    @Override
    public Optional<TrialLabel> trial() {
        return label;
    }

    @Override
    public SoccerField field() {
        return SoccerField.BEGINNER;
    }

    @Override
    public void order(Order order) {
        if (order instanceof Order.Pause) {
            pauseAfter(0);
        } else if (order instanceof Order.Resume) {
            change(() -> paused = false);
        } else if (order instanceof Order.Step step) {
            pauseAfter(step.cycles());
        } else if (order instanceof Order.SetSpeed set) {
            change(() -> speed = Math.max(MIN_SPEED, set.factor()));
            if (over) {
                reportStopped();
            }
        }
    }

    private void pauseAfter(int cycles) {
        change(() -> {
            paused = true;
            steps = cycles;
        });
    }

    @Override
    public void addObserver(SimulationObserver observer) {
        observers.add(observer);
        last.ifPresent(observer::cycleEnded);
    }

    @Override
    public void removeObserver(SimulationObserver observer) {
        observers.remove(observer);
    }
}
