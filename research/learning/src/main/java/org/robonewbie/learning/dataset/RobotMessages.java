package org.robonewbie.learning.dataset;

import java.nio.charset.StandardCharsets;
import org.robonewbie.nao.Joint;
import org.robonewbie.protocol.effector.EffectorCommand;
import org.robonewbie.protocol.effector.EffectorCommand.Say;
import org.robonewbie.protocol.effector.EffectorCommand.SetHingeSpeed;
import org.robonewbie.protocol.effector.EffectorMessageReader;
import org.robonewbie.protocol.frame.MessageBuffer;
import org.robonewbie.protocol.perceptor.PerceptorMessage;
import org.robonewbie.protocol.perceptor.PerceptorMessageReader;
import org.robonewbie.simulator.AgentMessages;

/** The latest messages between a robot and its agent, and the commands in effect. */
final class RobotMessages {

    private final PerceptorMessageReader perceptorReader = new PerceptorMessageReader();
    private final EffectorMessageReader effectorReader = new EffectorMessageReader();
    private final double[] degreesPerSecond = new double[Joint.COUNT];
    private String said = "";
    private AgentMessages last;

    RobotMessages(AgentMessages first) {
        this.last = first;
        update(first);
    }

    void update(AgentMessages messages) {
        last = messages;
        said = "";
        effectorReader.read(buffer(messages.effectors()), this::command, problem -> {});
    }

    private void command(EffectorCommand command) {
        if (command instanceof SetHingeSpeed speed) {
            Joint.ofEffector(speed.effectorName())
                    .ifPresent(joint -> degreesPerSecond[joint.ordinal()] = Math.toDegrees(speed.radiansPerSecond()));
        } else if (command instanceof Say say) {
            said = say.text();
        }
    }

    PerceptorMessage perceived() {
        return perceptorReader.read(buffer(last.perceptors()));
    }

    double commandedDegreesPerSecond(Joint joint) {
        return degreesPerSecond[joint.ordinal()];
    }

    /** Returns the message that the agent sends to other robots in this cycle; empty if there is none. */
    String said() {
        return said;
    }

    long cycle() {
        return last.cycle();
    }

    String perceptors() {
        return last.perceptors();
    }

    String effectors() {
        return last.effectors();
    }

    private static MessageBuffer buffer(String text) {
        byte[] bytes = text.getBytes(StandardCharsets.ISO_8859_1);
        MessageBuffer buffer = new MessageBuffer();
        buffer.resize(bytes.length);
        System.arraycopy(bytes, 0, buffer.bytes(), 0, bytes.length);
        return buffer;
    }
}
