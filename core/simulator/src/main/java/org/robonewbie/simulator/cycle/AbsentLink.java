package org.robonewbie.simulator.cycle;

import java.util.List;
import org.robonewbie.protocol.effector.EffectorMessageWriter;
import org.robonewbie.protocol.frame.MessageBuffer;

/**
 * A placeholder connection for an agent that belongs to a saved state but is not connected. It responds to each message
 * but never moves the robot.
 */
final class AbsentLink implements ServerLink {

    private boolean answerDue;

    @Override
    public boolean poll(MessageBuffer message) {
        if (!answerDue) {
            return false;
        }
        answerDue = false;
        message.clear();
        message.append(EffectorMessageWriter.SYNCHRONISE);
        return true;
    }

    @Override
    public boolean offer(MessageBuffer message) {
        answerDue = true;
        return true;
    }

    @Override
    public void setMessagesForAgent(List<byte[]> messages) {
        answerDue = true; // the saved agent may not have answered yet
    }

    @Override
    public boolean isOpen() {
        return true;
    }

    @Override
    public void close() {} // dropped when the next state is restored

    @Override
    public String address() {
        return "absent";
    }
}
