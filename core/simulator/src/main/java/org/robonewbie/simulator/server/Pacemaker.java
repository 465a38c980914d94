package org.robonewbie.simulator.server;

import org.robonewbie.nao.math.PortableMath;

/**
 * Keeps simulated time in step with real time. When a cycle takes too long, the lost time is dropped, so that the world
 * becomes slower for a moment instead of hurrying afterwards.
 */
final class Pacemaker {

    private static final double CYCLE_NANOSECONDS = 20e6;
    private static final long MEASURING_NANOSECONDS = 1_000_000_000L;

    private final RealTime time;
    private double speed;
    private long due;
    private boolean running;
    private long missedCycles;
    private long measuredCycles;
    private long measuringStart;
    private double realTimeFactor;

    Pacemaker(double speed, RealTime time) {
        this.speed = speed;
        this.time = time;
        this.measuringStart = time.nanoseconds();
    }

    void setSpeed(double newSpeed) {
        speed = newSpeed;
        excuse();
    }

    double speed() {
        return speed;
    }

    /** Forgets the time that has passed: the world was meant to stand still. */
    void excuse() {
        running = false;
    }

    /** Waits until the next cycle is due. */
    void awaitNextCycle() {
        long now = time.nanoseconds();
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
        time.awaitNanoseconds(due);
    }

    /** The number of cycles by which the world fell behind real time. */
    long missedCycles() {
        return missedCycles;
    }

    /** Simulated seconds per second over the last second. */
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
