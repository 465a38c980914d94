package org.robonewbie.agent;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.io.IOException;
import java.util.List;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.Test;
import org.robonewbie.agent.cycle.LinkPort;
import org.robonewbie.agent.cycle.RobotRuntime;
import org.robonewbie.agent.log.LogLine;
import org.robonewbie.agent.running.DeadlineMonitor;
import org.robonewbie.protocol.frame.AgentLink;
import org.robonewbie.protocol.frame.MessageBuffer;
import org.robonewbie.protocol.perceptor.PerceptorMessageWriter;

class PunctualityTest {

    private final RobotRuntime robot = new RobotRuntime("test");
    private final Server server = new Server();
    private final DeadlineMonitor port = new DeadlineMonitor(
            new LinkPort(server, new MessageBuffer()), robot, () -> "Slow.java:7", () -> server.nanoseconds);

    @Test
    void reportsACycleForWhichAServerInRealTimeDidNotWait() throws IOException {
        cycle(1.5, 30);

        assertThat(robot.diagnostics().reported())
                .singleElement()
                .asString()
                .contains("Cycle 1 took 30 ms, but the simulator advances after 20 ms; compute less in a"
                        + " cycle, and log instead of printing. Late cycles so far: 1.")
                .contains("Slow.java:7");
        assertThat(robot.log().lines()).extracting(LogLine::text).contains("cycle 1 came late: it took 30 ms");
    }

    @Test
    void keepsQuietWhileJavaWarmsUp() throws IOException {
        cycle(0.5, 30);

        assertThat(robot.diagnostics().reported()).isEmpty();
        assertThat(robot.log().lines()).extracting(LogLine::text).contains("cycle 1 came late: it took 30 ms");
    }

    @Test
    void reportsLateCyclesAgainAfterTenSeconds() throws IOException {
        for (double seconds : new double[] {3, 5, 13}) {
            cycle(seconds, 30);
        }

        assertThat(robot.diagnostics().reported()).hasSize(2).allMatch(line -> line.contains("Late cycles so far: "));
    }

    @Test
    void neverCallsAnAgentLateForWhichTheServerWaits() throws IOException {
        server.hasGoneOn = false;

        cycle(1.5, 30);

        assertThat(robot.diagnostics().reported()).isEmpty();
    }

    @Test
    void neverCallsAnAgentLateThatAnswersInTime() throws IOException {
        cycle(1.5, 19);

        assertThat(robot.diagnostics().reported()).isEmpty();
    }

    @Test
    void reportsHowFarARobotIsBehindAndCatchesUp() throws IOException {
        thinkTooLong(1500);

        assertThat(port.message().seconds().orElseThrow()).isEqualTo(3.5, within(1e-9));
        assertThat(robot.diagnostics().reported())
                .singleElement()
                .asString()
                .contains("The robot was 1.5 s behind the simulator")
                .contains("skipped 74 cycles", "Slow.java:7");
    }

    @Test
    void robotThatIsOnlyALittleLateSkipsNothing() throws IOException {
        thinkTooLong(100);

        assertThat(port.message().seconds().orElseThrow()).isEqualTo(2.02, within(1e-9));
        assertThat(robot.diagnostics().reported()).isEmpty();
    }

    /** At 2 s thinks for so long, while the server goes on, and receives the next message. */
    private void thinkTooLong(int milliseconds) throws IOException {
        server.newestSeconds = 2;
        server.seconds = 2;
        port.receive();
        server.newestSeconds = 2 + milliseconds / 1000.0;
        server.nanoseconds += TimeUnit.MILLISECONDS.toNanos(milliseconds);
        port.receive();
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
        private double newestSeconds = Double.NaN;

        @Override
        public boolean receive(MessageBuffer message) {
            boolean first = Double.isNaN(newestSeconds) || seconds == newestSeconds;
            seconds = first ? seconds : seconds + 0.02;
            message.clear();
            new PerceptorMessageWriter(message)
                    .write(Messages.standing().at(seconds).build());
            return true;
        }

        @Override
        public boolean isMessageWaiting() {
            return Double.isNaN(newestSeconds) ? hasGoneOn : seconds < newestSeconds - 0.01;
        }

        @Override
        public void send(MessageBuffer message) {}

        @Override
        public void close() {}
    }
}
