package org.robonewbie.workshop.speed;

import java.io.IOException;
import java.time.Duration;
import java.util.List;
import java.util.Timer;
import java.util.TimerTask;
import java.util.concurrent.CopyOnWriteArrayList;
import org.robonewbie.protocol.frame.AgentLink;

/** Ends all connections to a server that sends nothing any more, so that nobody waits for it for ever. */
final class StallGuard implements AutoCloseable {

    private static final int LOOKS = 4;

    private final Duration patience;
    private final List<AgentLink> links = new CopyOnWriteArrayList<>();
    private final Timer timer = new Timer("stall guard", true);
    private volatile long lastHeard = System.nanoTime();
    private volatile boolean stalled;

    StallGuard(Duration patience) {
        this.patience = patience;
        TimerTask look = new TimerTask() {
            @Override
            public void run() {
                look();
            }
        };
        timer.schedule(look, patience.toMillis(), Math.max(1, patience.toMillis() / LOOKS));
    }

    void watch(AgentLink link) {
        links.add(link);
    }

    /**
     * Notes that the server is alive.
     *
     * @param received whether it has sent a message; false if it has ended the connection
     * @throws IOException if the connection was ended here because the server was silent
     */
    void heard(boolean received) throws IOException {
        if (received) {
            lastHeard = System.nanoTime();
        } else {
            check();
        }
    }

    /** Fails if the server was silent for too long. */
    void check() throws IOException {
        if (stalled) {
            throw new IOException("The server has sent nothing for " + patience.toSeconds()
                    + " s. Is it in sync mode, and are no other agents connected, for which it waits?");
        }
    }

    private void look() {
        if (System.nanoTime() - lastHeard > patience.toNanos()) {
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
