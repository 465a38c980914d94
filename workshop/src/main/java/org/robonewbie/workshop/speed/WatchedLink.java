package org.robonewbie.workshop.speed;

import java.io.IOException;
import org.robonewbie.protocol.frame.AgentLink;
import org.robonewbie.protocol.frame.MessageBuffer;

/** Connection that reports a stalled server instead of a plain disconnect if a {@link StallGuard} has closed it. */
final class WatchedLink implements AgentLink {

    private final AgentLink link;
    private final StallGuard guard;

    WatchedLink(AgentLink link, StallGuard guard) {
        this.link = link;
        this.guard = guard;
        guard.watch(link);
    }

    @Override
    public void send(MessageBuffer message) throws IOException {
        try {
            link.send(message);
        } catch (IOException broken) {
            guard.check();
            throw broken;
        }
    }

    @Override
    public boolean receive(MessageBuffer message) throws IOException {
        boolean received = link.receive(message);
        guard.received(received);
        return received;
    }

    @Override
    public boolean isMessageWaiting() throws IOException {
        try {
            return link.isMessageWaiting();
        } catch (IOException broken) {
            guard.check();
            throw broken;
        }
    }

    @Override
    public void close() {
        link.close();
    }
}
