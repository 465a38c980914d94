package org.robonewbie.agent.cycle;

import java.io.IOException;
import java.util.List;
import org.robonewbie.protocol.effector.EffectorCommand;
import org.robonewbie.protocol.effector.EffectorMessageWriter;
import org.robonewbie.protocol.frame.AgentLink;
import org.robonewbie.protocol.frame.MessageBuffer;
import org.robonewbie.protocol.perceptor.PerceptorMessage;
import org.robonewbie.protocol.perceptor.PerceptorMessageReader;

/** Message port that parses the simulator's text and serialises the robot's commands. */
public final class LinkPort implements MessagePort {

    private final AgentLink link;
    private final MessageBuffer received;
    private final MessageBuffer answer = new MessageBuffer();
    private final EffectorMessageWriter writer = new EffectorMessageWriter(answer);
    private final PerceptorMessageReader reader = new PerceptorMessageReader();
    private PerceptorMessage message = PerceptorMessage.NOTHING;

    /**
     * Creates the port.
     *
     * @param link the connection to the simulator
     * @param received buffer for the text of each message
     */
    public LinkPort(AgentLink link, MessageBuffer received) {
        this.link = link;
        this.received = received;
    }

    @Override
    public boolean receive() throws IOException {
        boolean more = link.receive(received);
        if (more) {
            message = reader.read(received);
        }
        return more;
    }

    @Override
    public PerceptorMessage message() {
        return message;
    }

    @Override
    public void send(List<EffectorCommand> commands) throws IOException {
        answer.clear();
        commands.forEach(writer::write);
        link.send(answer);
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
