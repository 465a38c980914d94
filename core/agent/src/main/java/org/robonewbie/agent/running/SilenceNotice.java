package org.robonewbie.agent.running;

import java.io.PrintStream;
import java.time.Duration;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.TimeUnit;

/**
 * Says what to do when the server that a robot has joined says nothing: another program may use its port, or the simulator is paused or
 * waits for more players. The robot goes on waiting.
 */
public final class SilenceNotice implements AutoCloseable {

    private static final Duration PATIENCE = Duration.ofSeconds(5);

    private final CompletableFuture<Void> notice;

    private SilenceNotice(CompletableFuture<Void> notice) {
        this.notice = notice;
    }

    /**
     * Begins to wait for a server; says on {@code System.err} that it is silent.
     *
     * @param place where it listens, such as {@code localhost:3100}
     * @return the notice; close it when the server has answered
     */
    public static SilenceNotice of(String place) {
        return after(PATIENCE, place, System.err);
    }

    static SilenceNotice after(Duration patience, String place, PrintStream err) {
        Runnable words = () -> err.println("Nobody has answered at " + place + " for " + patience.toSeconds()
                + " s; the robot goes on waiting. Is the simulator there paused, or does it wait for more players? If another program uses"
                + " the port (\"robonewbie doctor\" looks), --seed 1 starts a simulator of its own.");
        return new SilenceNotice(CompletableFuture.runAsync(
                words, CompletableFuture.delayedExecutor(patience.toMillis(), TimeUnit.MILLISECONDS)));
    }

    /** Waits until the notice is given or dropped. */
    void await() {
        notice.join();
    }

    /** Drops the notice, since the server speaks. */
    @Override
    public void close() {
        notice.cancel(false);
    }
}
