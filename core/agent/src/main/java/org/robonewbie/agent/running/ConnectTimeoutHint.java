package org.robonewbie.agent.running;

import java.io.PrintStream;
import java.time.Duration;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.TimeUnit;

/**
 * Hint that is printed when the server does not respond: another program may use its port, or the simulator is paused
 * or waiting for more players. The robot continues to wait.
 */
public final class ConnectTimeoutHint implements AutoCloseable {

    private static final Duration TIMEOUT = Duration.ofSeconds(5);

    private final CompletableFuture<Void> hint;

    private ConnectTimeoutHint(CompletableFuture<Void> hint) {
        this.hint = hint;
    }

    /**
     * Schedules the hint to be printed on {@code System.err} after five seconds, unless it is closed first.
     *
     * @param place address of the server, such as {@code localhost:3100}
     * @return the hint; close it when the server has responded
     */
    public static ConnectTimeoutHint of(String place) {
        return after(TIMEOUT, place, System.err);
    }

    static ConnectTimeoutHint after(Duration timeout, String place, PrintStream err) {
        Runnable print = () -> err.println("No answer from " + place + " for " + timeout.toSeconds()
                + " s; still waiting. Is that simulator paused, or is it waiting for more players? If another program"
                + " uses the port (\"robonewbie doctor\" checks this), --seed 1 starts an embedded simulator.");
        return new ConnectTimeoutHint(CompletableFuture.runAsync(
                print, CompletableFuture.delayedExecutor(timeout.toMillis(), TimeUnit.MILLISECONDS)));
    }

    /** Waits until the hint is printed or cancelled. */
    void await() {
        hint.join();
    }

    /** Cancels the hint. */
    @Override
    public void close() {
        hint.cancel(false);
    }
}
