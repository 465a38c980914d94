package org.robonewbie.agent;

import java.io.IOException;
import java.util.Optional;
import org.robonewbie.protocol.frame.AgentLink;
import org.robonewbie.protocol.frame.MessageBuffer;
import org.robonewbie.protocol.perceptor.PerceptorMessage;
import org.robonewbie.protocol.perceptor.PerceptorMessageReader;

/** A connection to a simulator, be it in this process or elsewhere. */
final class LinkPort implements MessagePort {

    private final AgentLink link;
    private final MessageBuffer buffer;
    private final PerceptorMessageReader reader = new PerceptorMessageReader();

    /** Creates the port; the raw messages are put into the buffer. */
    LinkPort(AgentLink link, MessageBuffer buffer) {
        this.link = link;
        this.buffer = buffer;
    }

    @Override
    public Optional<PerceptorMessage> receive() throws IOException {
        return link.receive(buffer) ? Optional.of(reader.read(buffer)) : Optional.empty();
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
