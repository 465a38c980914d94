package org.robonewbie.simulator.server;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.io.IOException;
import java.util.Optional;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.robonewbie.nao.Joint;
import org.robonewbie.nao.TeamSide;
import org.robonewbie.protocol.frame.AgentLink;
import org.robonewbie.protocol.perceptor.PerceptorMessage;
import org.robonewbie.protocol.tcp.TcpAgentLink;
import org.robonewbie.simulator.SimulationControl;
import org.robonewbie.simulator.cycle.WorldSettings;

class AgentDialogueTest {

    private final RecordingConsole console = new RecordingConsole();

    enum Transport {
        TCP,
        IN_PROCESS;

        AgentLink connect(Simulator simulator) throws IOException {
            return this == TCP ? TcpAgentLink.connect("127.0.0.1", simulator.agentPort()) : simulator.connect();
        }
    }

    @ParameterizedTest
    @EnumSource
    void tellsNumberAndSideInSecondMessageAfterInit(Transport transport) throws IOException {
        try (Simulator simulator = start();
                TestAgent agent = new TestAgent(transport.connect(simulator))) {

            PerceptorMessage message = agent.join("Stars", 7);

            assertThat(message.gameState().orElseThrow().number()).hasValue(7);
            assertThat(message.gameState().orElseThrow().side()).isEqualTo(Optional.of(TeamSide.LEFT));
        }
    }

    @ParameterizedTest
    @EnumSource
    void tellsNumberAndSideOnlyOnce(Transport transport) throws IOException {
        try (Simulator simulator = start();
                TestAgent agent = new TestAgent(transport.connect(simulator))) {
            agent.join("Stars", 7);

            PerceptorMessage message = agent.exchange("(syn)");

            assertThat(message.gameState().orElseThrow().number()).isEmpty();
        }
    }

    @ParameterizedTest
    @EnumSource
    void showsEffectOfCommandTwoMessagesLater(Transport transport) throws IOException {
        try (Simulator simulator = start();
                TestAgent agent = new TestAgent(transport.connect(simulator))) {
            double before = neckYaw(agent.join("Stars", 1));

            double oneLater = neckYaw(agent.exchange("(he1 1)(syn)"));
            double twoLater = neckYaw(agent.exchange("(syn)"));

            assertThat(oneLater).isCloseTo(before, within(0.02));
            assertThat(twoLater - before).isCloseTo(Math.toDegrees(0.02), within(0.1));
        }
    }

    @ParameterizedTest
    @EnumSource
    void beamsToThePlaceInTeamView(Transport transport) throws IOException {
        try (Simulator simulator = start();
                TestAgent left = new TestAgent(transport.connect(simulator))) {
            left.join("Stars", 1);
            WorldWatcher watcher = new WorldWatcher();
            simulator.control().addObserver(watcher);

            left.exchange("(beam -3 1 45)(syn)");
            left.exchange("(syn)");

            assertThat(watcher.latest().robots().get(0).body().position().x()).isCloseTo(-3, within(0.001));
            assertThat(watcher.latest().robots().get(0).body().position().y()).isCloseTo(1, within(0.001));
        }
    }

    private static double neckYaw(PerceptorMessage message) {
        return message.jointAngles().degreesOr(Joint.NECK_YAW, Double.NaN);
    }

    private Simulator start() throws IOException {
        return Simulator.start(
                SimulatorSettings.of(WorldSettings.beginner())
                        .withAgentPort(0)
                        .withSpeed(SimulationControl.AS_FAST_AS_POSSIBLE)
                        .withAwaitedAgents(1),
                console);
    }
}
