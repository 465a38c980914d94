package org.robonewbie.web;

import java.io.IOException;
import java.io.UncheckedIOException;
import org.robonewbie.nao.state.Restorable;
import org.robonewbie.protocol.frame.AgentLink;
import org.robonewbie.protocol.frame.MessageBuffer;

/**
 * Link between a robot and the simulator. While the robot is joining, the link advances the world until a message arrives; afterwards, it
 * is non-blocking.
 */
final class PatientLink implements AgentLink {

    private final AgentLink link;
    private boolean patient = true;

    /**
     * Creates a blocking link.
     *
     * @param link advances the world while it waits for a message
     */
    PatientLink(AgentLink link) {
        this.link = link;
    }

    /** Makes the link non-blocking. */
    void stopWaiting() {
        patient = false;
    }

    @Override
    public boolean isMessageWaiting() {
        try {
            return link.isMessageWaiting();
        } catch (IOException lost) {
            throw new UncheckedIOException("The simulator on this page has closed the connection.", lost);
        }
    }

    @Override
    public void send(MessageBuffer message) throws IOException {
        link.send(message);
    }

    @Override
    public boolean receive(MessageBuffer message) throws IOException {
        return (patient || link.isMessageWaiting()) && link.receive(message);
    }

    @Override
    public void offerState(Restorable agent) {
        link.offerState(agent);
    }

    @Override
    public void close() {
        link.close();
    }
}
