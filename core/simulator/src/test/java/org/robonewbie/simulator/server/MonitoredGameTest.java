package org.robonewbie.simulator.server;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.net.InetAddress;
import java.net.ServerSocket;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Optional;
import java.util.OptionalInt;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.robonewbie.nao.Vector3;
import org.robonewbie.protocol.order.Order;
import org.robonewbie.protocol.tcp.MonitorLink;
import org.robonewbie.simulator.Console;
import org.robonewbie.simulator.SimulationControl;
import org.robonewbie.simulator.cycle.WorldSettings;

/** A whole game as monitors see it, and monitors as the game feels them. */
@Timeout(120)
class MonitoredGameTest {

    /** The modes in the order that magmaChallenge knows by number. */
    private static final String PLAY_MODES = "(play_modes BeforeKickOff KickOff_Left KickOff_Right PlayOn KickIn_Left"
            + " KickIn_Right corner_kick_left corner_kick_right goal_kick_left goal_kick_right offside_left"
            + " offside_right GameOver Goal_Left Goal_Right free_kick_left free_kick_right direct_free_kick_left"
            + " direct_free_kick_right pass_left pass_right)";

    private static final String ENVIRONMENT = "((FieldLength 30)(FieldWidth 20)(FieldHeight 40)(GoalWidth 2.1)"
            + "(GoalDepth 0.6)(GoalHeight 0.8)(BorderSize 0)(FreeKickDistance 2)(WaitBeforeKickOff 30)(AgentRadius 0.4)"
            + "(BallRadius 0.042)(BallMass 0.026)(RuleGoalPauseTime 3)(RuleKickInPauseTime 1)(RuleHalfTime 300)"
            + "(PassModeMinOppBallDist 1)(PassModeDuration 4)" + PLAY_MODES;

    @TempDir
    @SuppressWarnings("NullAway.Init")
    private Path folder;

    @Test
    void monitorThatComesWhileTheWorldStandsStillSeesItAndCanChangeIt() throws IOException {
        try (MonitoredSimulator match = new MonitoredSimulator()) {
            match.join("us", 1);
            match.simulator().control().order(new Order.Pause());
            try (MonitorLink late = match.connect()) {
                assertThat(late.receive()).isTrue();
                assertThat(late.world().robots()).hasSize(1);

                late.send(new Order.MoveBall(Optional.of(new Vector3(5, 5, 1)), Optional.empty()));
                while (late.world().ball().orElseThrow().position().x() < 4.9) {
                    assertThat(late.receive()).isTrue();
                }
            }
        }
    }

    @Test
    void waitingForASilentAgentDoesNotKeepMonitorsWaiting() throws IOException {
        try (Simulator simulator = Simulator.start(
                        SimulatorSettings.of(WorldSettings.league())
                                .withAgentPort(0)
                                .withMonitorPort(0),
                        Console.silent());
                TestAgent agent = new TestAgent(simulator.connect())) {
            agent.join("us", 3);
            try (MonitorLink monitor =
                    MonitorLink.connect("127.0.0.1", simulator.monitorPort().orElseThrow())) {
                assertThat(monitor.receive()).isTrue();
                assertThat(monitor.world().robots()).hasSize(1);
            }
        }
    }

    @Test
    void sameRunGivesTheSameLogForRoboViz() throws Exception {
        byte[] first = logOfARun("first.log");
        byte[] second = logOfARun("second.log");

        assertThat(second).isEqualTo(first);
        assertThat(new String(first, StandardCharsets.US_ASCII).lines())
                .hasSize(20)
                .first()
                .asString()
                .startsWith(ENVIRONMENT);
    }

    @Test
    void gameIsTheSameWhetherSomebodyWatchesOrNot() throws Exception {
        assertThat(checksumOfARun(true)).isEqualTo(checksumOfARun(false));
    }

    @Test
    void teamNameOfForeignLettersDoesNotBreakTheScene() throws IOException {
        try (MonitoredSimulator match = new MonitoredSimulator()) {
            match.join("\u0128\u0129", 1);

            match.await(seen -> seen.isCurrent() && seen.gameState().teamLeft().isPresent());
            assertThat(match.world().gameState().teamLeft()).contains("\u0128\u0129");
            assertThat(match.world().robots()).hasSize(1);
        }
    }

    @Test
    void monitorPortInUseLeavesNoAgentPortBehind() throws IOException {
        try (ServerSocket taken = new ServerSocket(0, 1, InetAddress.getLoopbackAddress())) {
            int agentPort;
            try (ServerSocket free = new ServerSocket(0)) {
                agentPort = free.getLocalPort();
            }
            SimulatorSettings settings = SimulatorSettings.of(
                            WorldSettings.league().withSynchronous(false))
                    .withAgentPort(agentPort)
                    .withMonitorPort(taken.getLocalPort());

            assertThatThrownBy(() -> Simulator.start(settings, Console.silent()))
                    .isInstanceOf(IOException.class)
                    .hasMessageContaining("Monitor port " + taken.getLocalPort());
            try (ServerSocket again = new ServerSocket(agentPort)) {
                assertThat(again.isBound()).isTrue();
            }
        }
    }

    private byte[] logOfARun(String name) throws Exception {
        Path file = folder.resolve(name);
        try (Simulator simulator = Simulator.start(
                shortRun()
                        .withMonitors(
                                new SimulatorSettings.Monitors(OptionalInt.empty(), 0.04, true, Optional.of(file))),
                Console.silent())) {
            play(simulator);
        }
        return Files.readAllBytes(file);
    }

    private static String checksumOfARun(boolean isWatched) throws Exception {
        try (Simulator simulator = Simulator.start(shortRun().withMonitorPort(0), Console.silent())) {
            if (!isWatched) {
                play(simulator);
                return simulator.report().orElseThrow().recordingSha256();
            }
            try (MonitorLink monitor =
                    MonitorLink.connect("127.0.0.1", simulator.monitorPort().orElseThrow())) {
                assertThat(monitor.receive()).isTrue();
                play(simulator);
                assertThat(monitor.receive()).isTrue();
                return simulator.report().orElseThrow().recordingSha256();
            }
        }
    }

    private static SimulatorSettings shortRun() {
        return SimulatorSettings.of(WorldSettings.league().withSeed(3))
                .withAgentPort(0)
                .withSpeed(SimulationControl.AS_FAST_AS_POSSIBLE)
                .withAwaitedAgents(1)
                .withSeconds(4);
    }

    private static void play(Simulator simulator) throws Exception {
        try (TestAgent agent = new TestAgent(simulator.connect())) {
            agent.join("us", 1);
            try {
                while (true) {
                    agent.exchange("(he1 0.5)(lle3 -0.3)(syn)");
                }
            } catch (IOException ended) {
                simulator.awaitEnd();
            }
        }
    }
}
