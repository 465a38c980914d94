package org.robonewbie.simulator.cycle;

import java.util.List;
import org.robonewbie.protocol.effector.EffectorMessageWriter;
import org.robonewbie.protocol.frame.MessageBuffer;

/** Stands in for an agent that was there when the world was saved and is not there now: it answers, but never moves. */
final class AbsentLink implements ServerLink {

    private boolean owesAnswer;

    @Override
    public boolean poll(MessageBuffer message) {
        if (!owesAnswer) {
            return false;
        }
        owesAnswer = false;
        message.clear();
        message.append(EffectorMessageWriter.SYNCHRONISE);
        return true;
    }

    @Override
    public boolean offer(MessageBuffer message) {
        owesAnswer = true;
        return true;
    }

    /** The agent that was there may have owed an answer. */
    @Override
    public void setMessagesForAgent(List<byte[]> messages) {
        owesAnswer = true;
    }

    @Override
    public boolean isOpen() {
        return true;
    }

    @Override
    public String closingReason() {
        return HAS_LEFT;
    }

    /** There is nothing to close; the next state that is restored drops it. */
    @Override
    public void close() {}

    @Override
    public boolean isLocal() {
        return true;
    }

    @Override
    public String address() {
        return "absent";
    }
}
