package org.robonewbie.simulator.server;

import java.util.concurrent.locks.LockSupport;
import java.util.function.LongConsumer;
import java.util.function.LongSupplier;
import org.robonewbie.nao.math.PortableMath;

/**
 * Synchronises simulated time with real time. Time lost in a slow cycle is not made up: the simulation falls behind
 * rather than running faster afterwards.
 */
final class Pacemaker {

    private static final double CYCLE_NANOSECONDS = 20e6;
    private static final long MEASURING_NANOSECONDS = 1_000_000_000L;

    private final LongSupplier nanoTime;
    private final LongConsumer sleepUntil;
    private double speed;
    private long due;
    private boolean running;
    private long missedCycles;
    private long measuredCycles;
    private long measuringStart;
    private double realTimeFactor;

    Pacemaker(double speed) {
        this(speed, System::nanoTime, Pacemaker::sleepUntil);
    }

    /**
     * Creates a pacemaker with a custom clock: its time in nanoseconds, and a method that blocks until a given time on
     * this clock.
     */
    Pacemaker(double speed, LongSupplier nanoTime, LongConsumer sleepUntil) {
        this.speed = speed;
        this.nanoTime = nanoTime;
        this.sleepUntil = sleepUntil;
        this.measuringStart = nanoTime.getAsLong();
    }

    private static void sleepUntil(long nanoTime) {
        while (nanoTime - System.nanoTime() > 0) {
            LockSupport.parkNanos(nanoTime - System.nanoTime());
        }
    }

    void setSpeed(double newSpeed) {
        speed = newSpeed;
        pause();
    }

    double speed() {
        return speed;
    }

    /** Excludes the time until the next cycle from the measured speed. */
    void pause() {
        running = false;
    }

    /** Waits until the next cycle is due. */
    void awaitNextCycle() {
        long now = nanoTime.getAsLong();
        measure(now);
        if (Double.isInfinite(speed)) {
            return;
        }
        long length = PortableMath.round(CYCLE_NANOSECONDS / speed);
        due = running ? due + length : now + length;
        running = true;
        long late = now - due;
        if (late > length) {
            missedCycles += late / length;
            due = now;
        }
        sleepUntil.accept(due);
    }

    /** Returns the number of cycles by which the simulation has fallen behind real time. */
    long missedCycles() {
        return missedCycles;
    }

    /** Returns the simulated seconds per real second, measured over the last second. */
    double realTimeFactor() {
        return realTimeFactor;
    }

    private void measure(long now) {
        measuredCycles++;
        long elapsed = now - measuringStart;
        if (elapsed >= MEASURING_NANOSECONDS) {
            realTimeFactor = measuredCycles * CYCLE_NANOSECONDS / elapsed;
            measuringStart = now;
            measuredCycles = 0;
        }
    }
}
