package org.robonewbie.simulator.server;

import java.util.concurrent.locks.LockSupport;

/** The time that passes outside of the world. */
interface RealTime {

    /** The computer's clock. */
    RealTime CLOCK = new RealTime() {
        @Override
        public long nanoseconds() {
            return System.nanoTime();
        }

        @Override
        public void awaitNanoseconds(long moment) {
            while (moment - System.nanoTime() > 0) {
                LockSupport.parkNanos(moment - System.nanoTime());
            }
        }
    };

    /** {@return a moment, counted from any beginning} */
    long nanoseconds();

    /**
     * Waits until a moment, or returns at once if it is over.
     *
     * @param moment as {@link #nanoseconds} counts
     */
    void awaitNanoseconds(long moment);
}
