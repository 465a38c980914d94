package org.robonewbie.app.soak;

import java.io.IOException;
import java.util.List;
import java.util.OptionalDouble;
import java.util.concurrent.Callable;
import org.robonewbie.nao.Cycle;
import org.robonewbie.nao.geometry.Pose2d;
import org.robonewbie.protocol.effector.EffectorMessageWriter;
import org.robonewbie.protocol.frame.AgentLink;
import org.robonewbie.protocol.frame.MessageBuffer;
import org.robonewbie.protocol.perceptor.PerceptorMessage;
import org.robonewbie.protocol.perceptor.PerceptorMessageReader;
import org.robonewbie.protocol.tcp.TcpAgentLink;

/** A robot that answers each message, bends its knees, and counts the cycles of which it has heard nothing. */
final class HonestRobot implements Callable<HonestRobot.Count> {

    private static final double BEND_RADIANS_PER_SECOND = 0.5;

    private final AgentLink link;
    private final int number;
    private final Listener listener;
    private final MessageBuffer message = new MessageBuffer();
    private final PerceptorMessageReader reader = new PerceptorMessageReader();

    /** Is told of each cycle. */
    interface Listener {
        void heard(long cycles);
    }

    /**
     * What it has experienced.
     *
     * @param heard cycles of which it has got a message
     * @param lost cycles in between of which it has got none
     */
    record Count(long heard, long lost) {}

    HonestRobot(int port, int number, Listener listener) throws IOException {
        this.link = TcpAgentLink.connect("127.0.0.1", port);
        this.number = number;
        this.listener = listener;
    }

    @Override
    public Count call() throws IOException {
        long heard = 0;
        long lost = 0;
        OptionalDouble last = OptionalDouble.empty();
        try (link) {
            answer().createRobot("rsg/agent/nao/nao.rsg", List.of());
            send();
            while (link.receive(message)) {
                PerceptorMessage felt = reader.read(message);
                double now = felt.seconds().orElseThrow();
                lost += last.isPresent() ? Math.round((now - last.getAsDouble()) / Cycle.SECONDS) - 1 : 0;
                last = OptionalDouble.of(now);
                heard++;
                listener.heard(heard);
                act(heard);
                send();
            }
        } catch (IOException serverHasEnded) {
            // What counts is what was heard until then.
        }
        return new Count(heard, lost);
    }

    private EffectorMessageWriter answer() {
        message.clear();
        return new EffectorMessageWriter(message);
    }

    private void send() throws IOException {
        new EffectorMessageWriter(message).synchronise();
        link.send(message);
    }

    private void act(long heard) {
        EffectorMessageWriter writer = answer();
        if (heard == 1) {
            writer.joinTeam(number, "Honest");
        } else if (heard == 2) {
            writer.beam(new Pose2d(-1 - number, number % 5 - 2.0, 0));
        } else {
            double speed = BEND_RADIANS_PER_SECOND * Math.cos(heard * 0.1);
            writer.hingeSpeed("lle4", -speed).hingeSpeed("rle4", -speed).hingeSpeed("he1", speed);
        }
    }
}
