package org.robonewbie.agent.cycle;

import java.util.List;
import org.robonewbie.protocol.effector.EffectorCommand;
import org.robonewbie.protocol.perceptor.PerceptorMessage;

/** Message port without a simulator: delivers one perceptor message at a time and keeps the response. */
public final class SingleMessagePort implements MessagePort {

    private PerceptorMessage message = PerceptorMessage.NOTHING;
    private boolean isNew;
    private List<EffectorCommand> answer = List.of();

    /** Creates a port without a perceptor message. */
    public SingleMessagePort() {}

    /**
     * Sets the next perceptor message.
     *
     * @param newMessage the perceptors' readings
     */
    public void put(PerceptorMessage newMessage) {
        message = newMessage;
        isNew = true;
        answer = List.of();
    }

    /** {@return the response to the last perceptor message; empty if there was none} */
    public List<EffectorCommand> answer() {
        return answer;
    }

    @Override
    public boolean receive() {
        boolean received = isNew;
        isNew = false;
        return received;
    }

    @Override
    public PerceptorMessage message() {
        return message;
    }

    @Override
    public void send(List<EffectorCommand> commands) {
        answer = commands;
    }

    @Override
    public void close() {}
}
