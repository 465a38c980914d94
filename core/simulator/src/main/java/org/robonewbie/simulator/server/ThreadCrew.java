package org.robonewbie.simulator.server;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.concurrent.locks.LockSupport;
import java.util.function.IntConsumer;
import org.jspecify.annotations.Nullable;
import org.robonewbie.simulator.physics.Crew;

/**
 * A pool of threads for data-parallel loops. The calling thread and the helper threads, which sleep between loops, take
 * iterations dynamically, so a helper that wakes up late causes no delay.
 *
 * <pre>{@code
 * try (ThreadCrew crew = new ThreadCrew(2)) {
 *     crew.divide(robots.size(), robot -> think(robots.get(robot)));
 * }
 * }</pre>
 *
 * <p>Only one thread at a time may call {@link #divide}, and not from within an iteration.
 */
public final class ThreadCrew implements Crew, AutoCloseable {

    private static final Job EMPTY = new Job(0, piece -> {});

    private final List<Thread> helpers = new ArrayList<>();
    private volatile Job job = EMPTY;
    private volatile boolean closed;

    /**
     * Starts the helpers as daemon threads.
     *
     * @param threads number of threads including the caller, at least 1
     */
    public ThreadCrew(int threads) {
        for (int i = 1; i < threads; i++) {
            Thread helper = new Thread(this::help, "RoboNewbie-crew-" + i);
            helper.setDaemon(true);
            helpers.add(helper);
            helper.start();
        }
    }

    @Override
    public void divide(int pieces, IntConsumer work) {
        if (helpers.isEmpty() || pieces < 2) {
            ALONE.divide(pieces, work);
            return;
        }
        Job shared = new Job(pieces, work);
        job = shared;
        helpers.forEach(LockSupport::unpark);
        shared.takePieces();
        shared.await();
    }

    /** {@return the helper threads, for measurements} */
    public List<Thread> helpers() {
        return Collections.unmodifiableList(helpers);
    }

    private void help() {
        Job last = EMPTY;
        while (!closed) {
            Job now = job;
            if (now == last) {
                LockSupport.park(this);
            } else {
                now.takePieces();
                last = now;
            }
        }
    }

    /** Stops the helper threads. */
    @Override
    public void close() {
        closed = true;
        helpers.forEach(LockSupport::unpark);
    }

    /** One parallel loop. */
    private static final class Job {

        /**
         * Number of spins before the caller parks, because parking usually takes longer than the iterations still
         * running.
         */
        private static final int SPINS = 2_000;

        private final Thread owner = Thread.currentThread();
        private final int pieces;
        private final IntConsumer work;
        private final AtomicInteger next = new AtomicInteger();
        private final AtomicInteger missing;
        private volatile @Nullable Throwable failure;

        Job(int pieces, IntConsumer work) {
            this.pieces = pieces;
            this.work = work;
            this.missing = new AtomicInteger(pieces);
        }

        void takePieces() {
            for (int piece = next.getAndIncrement(); piece < pieces; piece = next.getAndIncrement()) {
                try {
                    work.accept(piece);
                } catch (RuntimeException | Error thrown) {
                    failure = thrown;
                }
                if (missing.decrementAndGet() == 0) {
                    LockSupport.unpark(owner);
                }
            }
        }

        void await() {
            for (int i = 0; i < SPINS && missing.get() > 0; i++) {
                Thread.onSpinWait();
            }
            while (missing.get() > 0) {
                LockSupport.park(this);
            }
            if (failure instanceof Error error) {
                throw error;
            }
            if (failure instanceof RuntimeException exception) {
                throw exception;
            }
        }
    }
}
