package org.robonewbie.agent;

import java.util.ArrayList;
import java.util.List;
import org.robonewbie.protocol.effector.EffectorCommand;
import org.robonewbie.protocol.effector.EffectorMessageReader;
import org.robonewbie.protocol.frame.MessageBuffer;
import org.robonewbie.protocol.perceptor.PerceptorMessage;

/** Gives a robot one perception and keeps its answer, without any simulator. */
final class RehearsalPort implements MessagePort {

    private PerceptorMessage message = PerceptorMessage.NOTHING;
    private boolean isNew;
    private List<EffectorCommand> answer = List.of();

    void put(PerceptorMessage message) {
        this.message = message;
        isNew = true;
        answer = List.of();
    }

    List<EffectorCommand> answer() {
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
    public void send(MessageBuffer commands) {
        List<EffectorCommand> all = new ArrayList<>();
        new EffectorMessageReader().read(commands, all::add, problem -> {});
        answer = List.copyOf(all);
    }

    @Override
    public boolean isLate() {
        return false;
    }

    @Override
    public void close() {}
}
