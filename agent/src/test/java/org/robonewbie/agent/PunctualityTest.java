package org.robonewbie.agent;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.util.List;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.Test;
import org.robonewbie.agent.cycle.Clockwork;
import org.robonewbie.agent.cycle.LinkPort;
import org.robonewbie.agent.log.LogLine;
import org.robonewbie.agent.running.PunctualPort;
import org.robonewbie.protocol.frame.AgentLink;
import org.robonewbie.protocol.frame.MessageBuffer;
import org.robonewbie.protocol.perceptor.PerceptorMessageWriter;

class PunctualityTest {

    private final Clockwork robot = new Clockwork("test");
    private final Server server = new Server();
    private final PunctualPort port = new PunctualPort(
            new LinkPort(server, new MessageBuffer()), robot, () -> "Slow.java:7", () -> server.nanoseconds);

    @Test
    void reportsACycleForWhichAServerInRealTimeDidNotWait() throws IOException {
        cycle(1.5, 30);

        assertThat(robot.mistakes().reported())
                .singleElement()
                .asString()
                .contains("Cycle 1 took 30 ms, but the simulator waits only 20 ms and has gone on; compute less in a"
                        + " cycle, and log instead of printing. Late cycles so far: 1.")
                .contains("Slow.java:7");
        assertThat(robot.log().lines()).extracting(LogLine::text).contains("cycle 1 came late: it took 30 ms");
    }

    @Test
    void keepsQuietWhileJavaWarmsUp() throws IOException {
        cycle(0.5, 30);

        assertThat(robot.mistakes().reported()).isEmpty();
        assertThat(robot.log().lines()).extracting(LogLine::text).contains("cycle 1 came late: it took 30 ms");
    }

    @Test
    void reportsLateCyclesAgainAfterTenSeconds() throws IOException {
        for (double seconds : new double[] {3, 5, 13}) {
            cycle(seconds, 30);
        }

        assertThat(robot.mistakes().reported()).hasSize(2).allMatch(line -> line.contains("Late cycles so far: "));
    }

    @Test
    void neverCallsAnAgentLateForWhichTheServerWaits() throws IOException {
        server.hasGoneOn = false;

        cycle(1.5, 30);

        assertThat(robot.mistakes().reported()).isEmpty();
    }

    @Test
    void neverCallsAnAgentLateThatAnswersInTime() throws IOException {
        cycle(1.5, 19);

        assertThat(robot.mistakes().reported()).isEmpty();
    }

    private void cycle(double seconds, int milliseconds) throws IOException {
        server.seconds = seconds;
        port.receive();
        robot.perceive(port.message());
        server.nanoseconds += TimeUnit.MILLISECONDS.toNanos(milliseconds);
        port.send(List.of());
    }

    /** A server whose clock the test turns. */
    private static final class Server implements AgentLink {

        private double seconds;
        private long nanoseconds;
        private boolean hasGoneOn = true;

        @Override
        public boolean receive(MessageBuffer message) {
            message.clear();
            new PerceptorMessageWriter(message)
                    .write(Messages.standing().at(seconds).build());
            return true;
        }

        @Override
        public boolean isMessageWaiting() {
            return hasGoneOn;
        }

        @Override
        public void send(MessageBuffer message) {}

        @Override
        public void close() {}
    }
}
