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
 * Several threads that share work: the one that asks, and helpers that sleep in between. Each takes the next piece as soon as it is
 * done with one, so that nobody waits for a helper that wakes late.
 *
 * <pre>{@code
 * try (ThreadCrew crew = new ThreadCrew(2)) {
 *     crew.divide(robots.size(), robot -> think(robots.get(robot)));
 * }
 * }</pre>
 *
 * <p>Only one thread at a time may ask, and no piece may ask for help with its own work.
 */
public final class ThreadCrew implements Crew, AutoCloseable {

    private static final Job NOTHING = new Job(0, piece -> {});

    private final List<Thread> helpers = new ArrayList<>();
    private volatile Job job = NOTHING;
    private volatile boolean closed;

    /**
     * Starts the helpers; they do not keep a program alive.
     *
     * @param threads how many threads work, with the one that asks; at least 1
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

    /** {@return the helpers, to measure what they cost} */
    public List<Thread> helpers() {
        return Collections.unmodifiableList(helpers);
    }

    private void help() {
        Job last = NOTHING;
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

    /** Sends the helpers home. */
    @Override
    public void close() {
        closed = true;
        helpers.forEach(LockSupport::unpark);
    }

    /** Work of one kind; who comes late finds no pieces left. */
    private static final class Job {

        /** So often the one that asked looks whether the last pieces are done before it goes to sleep, which takes longer than a piece. */
        private static final int LOOKS = 2_000;

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
            for (int look = 0; look < LOOKS && missing.get() > 0; look++) {
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
