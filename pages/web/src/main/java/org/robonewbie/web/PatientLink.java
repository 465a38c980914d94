package org.robonewbie.web;

import java.io.IOException;
import java.io.UncheckedIOException;
import org.robonewbie.nao.state.Restorable;
import org.robonewbie.protocol.frame.AgentLink;
import org.robonewbie.protocol.frame.MessageBuffer;

/** Turns the world until the robot is on its place; from then on a message is taken only if it is there. */
final class PatientLink implements AgentLink {

    private final AgentLink link;
    private boolean patient = true;

    /**
     * Creates a link.
     *
     * @param link turns the world while it waits for a message
     */
    PatientLink(AgentLink link) {
        this.link = link;
    }

    /** Waits for no message any more. */
    void beBusy() {
        patient = false;
    }

    @Override
    public boolean isMessageWaiting() {
        try {
            return link.isMessageWaiting();
        } catch (IOException lost) {
            throw new UncheckedIOException("The world of the page has closed its connection.", lost);
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
