package org.robonewbie.simulator.server;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.net.InetAddress;
import java.net.Socket;
import java.util.List;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.robonewbie.protocol.tcp.MonitorLink;
import org.robonewbie.protocol.tcp.TcpAgentLink;
import org.robonewbie.simulator.SimulationControl;
import org.robonewbie.simulator.cycle.WorldSettings;

/**
 * Hundreds of clients talk nonsense to the real ports, the same nonsense in each run, while a good agent and a good monitor must
 * get one sound message after the other.
 */
@Timeout(120)
class FuzzedPortsTest {

    private static final int CLIENTS = 150;
    private static final int MAX_FRAMES = 20;

    private final RecordingConsole console = new RecordingConsole();
    private final RoboVizReader roboViz = new RoboVizReader();

    @ParameterizedTest
    @ValueSource(longs = {1, 2, 3})
    void nonsenseAtTheAgentPortHarmsNobodyElse(long seed) throws IOException {
        FuzzedMessages messages = new FuzzedMessages(FuzzedMessages.OF_AGENTS, seed);
        try (Simulator simulator = start()) {
            harass(simulator, simulator.agentPort(), messages);
        }
    }

    @ParameterizedTest
    @ValueSource(longs = {1, 2, 3})
    void nonsenseAtTheMonitorPortHarmsNobodyElse(long seed) throws IOException {
        FuzzedMessages messages = new FuzzedMessages(FuzzedMessages.OF_TRAINERS, seed);
        try (Simulator simulator = start()) {
            harass(simulator, simulator.monitorPort().orElseThrow(), messages);
        }
    }

    private void harass(Simulator simulator, int port, FuzzedMessages messages) throws IOException {
        try (TestAgent agent = new TestAgent(TcpAgentLink.connect("127.0.0.1", simulator.agentPort()));
                MonitorLink monitor =
                        MonitorLink.connect("127.0.0.1", simulator.monitorPort().orElseThrow())) {
            agent.joinRunningGame("Stars", 2);
            for (int i = 0; i < CLIENTS; i++) {
                beNasty(port, messages);
                checkOthers(agent, monitor);
            }
            for (int i = 0; i < 20; i++) {
                checkOthers(agent, monitor);
            }
        }
        assertThat(console.sentences())
                .noneMatch(sentence -> sentence.contains("has failed") || sentence.contains("stopped working"));
    }

    private static void beNasty(int port, FuzzedMessages messages) throws IOException {
        try (Socket client = new Socket(InetAddress.getLoopbackAddress(), port)) {
            for (int i = messages.count(MAX_FRAMES); i > 0; i--) {
                client.getOutputStream().write(messages.frame());
            }
        } catch (IOException hungUp) {
            // The server has had enough of this client.
        }
    }

    /** Reads a message as strictly as the clients of the league do. */
    private void checkOthers(TestAgent agent, MonitorLink monitor) throws IOException {
        agent.send("(syn)");
        String text = agent.receiveText().toString();
        List<String> tags = new FcPortugalParser(text).allTags();
        assertThat(tags).startsWith("time", "now", "GS").contains("GYR", "ACC", "HJ");
        assertThat(text.chars().filter(character -> character == '(').count())
                .isEqualTo(text.chars().filter(character -> character == ')').count());
        assertThat(monitor.receive()).as("%s", console.sentences()).isTrue();
        roboViz.read(monitor.lastMessage().toString());
    }

    private Simulator start() throws IOException {
        return Simulator.start(
                SimulatorSettings.of(WorldSettings.league().withSeed(1).withSynchronous(false))
                        .withAgentPort(0)
                        .withMonitorPort(0)
                        .withSpeed(SimulationControl.AS_FAST_AS_POSSIBLE),
                console);
    }
}
