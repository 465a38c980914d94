package org.robonewbie.workshop.speed;

import java.io.IOException;
import java.time.Duration;
import java.util.List;
import java.util.Timer;
import java.util.TimerTask;
import java.util.concurrent.CopyOnWriteArrayList;
import org.robonewbie.protocol.frame.AgentLink;

/** Closes the connections to a stalled server so that no agent blocks forever. */
final class StallGuard implements AutoCloseable {

    private static final int CHECKS_PER_TIMEOUT = 4;

    private final Duration patience;
    private final List<AgentLink> links = new CopyOnWriteArrayList<>();
    private final Timer timer = new Timer("stall guard", true);
    private volatile long lastMessage = System.nanoTime();
    private volatile boolean stalled;

    StallGuard(Duration patience) {
        this.patience = patience;
        TimerTask task = new TimerTask() {
            @Override
            public void run() {
                closeIfStalled();
            }
        };
        timer.schedule(task, patience.toMillis(), Math.max(1, patience.toMillis() / CHECKS_PER_TIMEOUT));
    }

    void watch(AgentLink link) {
        links.add(link);
    }

    /**
     * Records activity of the server.
     *
     * @param received whether a message arrived; false if the connection was closed
     * @throws IOException if this guard closed the connection because the server had stalled
     */
    void received(boolean received) throws IOException {
        if (received) {
            lastMessage = System.nanoTime();
        } else {
            check();
        }
    }

    /** Throws if the server has stalled. */
    void check() throws IOException {
        if (stalled) {
            throw new IOException("The server has sent nothing for " + patience.toSeconds()
                    + " s. Check that it runs in sync mode and that no other agents are connected.");
        }
    }

    private void closeIfStalled() {
        if (System.nanoTime() - lastMessage > patience.toNanos()) {
            stalled = true;
            links.forEach(AgentLink::close);
        }
    }

    @Override
    public void close() {
        timer.cancel();
        links.forEach(AgentLink::close);
    }
}
