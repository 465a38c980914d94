package org.robonewbie.agent;

import java.io.IOException;
import org.robonewbie.protocol.frame.AgentLink;
import org.robonewbie.protocol.frame.MessageBuffer;
import org.robonewbie.protocol.perceptor.PerceptorMessage;
import org.robonewbie.protocol.perceptor.PerceptorMessageReader;

/** A connection to a simulator, be it in this process or elsewhere. */
final class LinkPort implements MessagePort {

    private final AgentLink link;
    private final MessageBuffer buffer;
    private final PerceptorMessageReader reader = new PerceptorMessageReader();
    private PerceptorMessage message = PerceptorMessage.NOTHING;

    /** Creates the port; the raw messages are put into the buffer. */
    LinkPort(AgentLink link, MessageBuffer buffer) {
        this.link = link;
        this.buffer = buffer;
    }

    @Override
    public boolean receive() throws IOException {
        boolean received = link.receive(buffer);
        if (received) {
            message = reader.read(buffer);
        }
        return received;
    }

    @Override
    public PerceptorMessage message() {
        return message;
    }

    @Override
    public void send(MessageBuffer commands) throws IOException {
        link.send(commands);
    }

    @Override
    public boolean isLate() throws IOException {
        return link.isMessageWaiting();
    }

    @Override
    public void close() {
        link.close();
    }
}
