package org.robonewbie.agent;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.robonewbie.protocol.effector.EffectorCommand;
import org.robonewbie.protocol.effector.EffectorMessageReader;
import org.robonewbie.protocol.frame.MessageBuffer;
import org.robonewbie.protocol.perceptor.PerceptorMessage;

/** Gives a robot one perception and keeps its answer, without any simulator. */
final class RehearsalPort implements MessagePort {

    private Optional<PerceptorMessage> next = Optional.empty();
    private List<EffectorCommand> answer = List.of();

    void put(PerceptorMessage message) {
        next = Optional.of(message);
        answer = List.of();
    }

    List<EffectorCommand> answer() {
        return answer;
    }

    @Override
    public Optional<PerceptorMessage> receive() {
        Optional<PerceptorMessage> message = next;
        next = Optional.empty();
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
