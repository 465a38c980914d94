package org.robonewbie.simulator.server;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Random;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.robonewbie.protocol.frame.AgentLink;
import org.robonewbie.protocol.tcp.TcpAgentLink;
import org.robonewbie.simulator.SimulationControl;
import org.robonewbie.simulator.cycle.WorldSettings;
import org.robonewbie.simulator.recording.RunReport;
import org.robonewbie.simulator.soccer.SoccerParameters;

class DeterminismTest {

    @Test
    void sameSeedGivesSameRecordingWithOneAgent() throws Exception {
        RunReport first = run(1, false, settings(1, 7));
        RunReport second = run(1, false, settings(1, 7));

        assertThat(first.simulatedSeconds()).isEqualTo(6);
        assertThat(first.recordingSha256()).isEqualTo(second.recordingSha256());
    }

    @Test
    void sameSeedGivesSameRecordingWithTwoAgentsInThreads() throws Exception {
        RunReport first = run(2, false, settings(2, 7));
        RunReport second = run(2, false, settings(2, 7));

        assertThat(first.robots()).hasSize(2);
        assertThat(first.recordingSha256()).isEqualTo(second.recordingSha256());
    }

    @Test
    void sameSeedGivesSameRecordingWithTwoAgentsOverTcp() throws Exception {
        RunReport first = run(2, true, settings(2, 7));
        RunReport second = run(2, true, settings(2, 7));

        assertThat(first.recordingSha256()).isEqualTo(second.recordingSha256());
    }

    @Test
    void sameSeedGivesSameRecordingWithTwentyTwoAgentsInThreads() throws Exception {
        RunReport first = run(22, false, league(22, 7));
        RunReport second = run(22, false, league(22, 7));

        assertThat(first.robots()).hasSize(22);
        assertThat(first.recordingSha256()).isEqualTo(second.recordingSha256());
    }

    @Test
    void orderOfTcpConnectionsDoesNotMatterForTwentyTwoAwaitedAgents() throws Exception {
        List<Integer> numbers = numbers(22);
        RunReport first = runOverTcp(numbers);
        Collections.reverse(numbers);
        RunReport second = runOverTcp(numbers);
        Collections.shuffle(numbers, new Random(1));
        RunReport third = runOverTcp(numbers);

        assertThat(first.robots()).hasSize(22);
        assertThat(second.recordingSha256()).isEqualTo(first.recordingSha256());
        assertThat(third.recordingSha256()).isEqualTo(first.recordingSha256());
    }

    @Test
    void awaitedAgentsThatJoinWithoutSynGiveSameRecordingToo() throws Exception {
        assertThat(runWithoutSynAtFirst()).isEqualTo(runWithoutSynAtFirst());
    }

    @Test
    void tcpAndInProcessGiveSameRecording() throws Exception {
        RunReport overTcp = run(1, true, settings(1, 7));
        RunReport inProcess = run(1, false, settings(1, 7));

        assertThat(overTcp.recordingSha256()).isEqualTo(inProcess.recordingSha256());
    }

    @Test
    void otherSeedGivesOtherRecording() throws Exception {
        RunReport first = run(1, false, settings(1, 7));
        RunReport second = run(1, false, settings(1, 8));

        assertThat(first.recordingSha256()).isNotEqualTo(second.recordingSha256());
    }

    @Test
    void agentThatEndsItselfGivesSameRecording() throws Exception {
        assertThat(runUntilAgentLeaves()).isEqualTo(runUntilAgentLeaves());
    }

    private static RunReport run(int agents, boolean overTcp, SimulatorSettings settings) throws Exception {
        try (Simulator simulator = Simulator.start(settings, new RecordingConsole())) {
            for (int i = 1; i <= agents; i++) {
                AgentLink link =
                        overTcp ? TcpAgentLink.connect("127.0.0.1", simulator.agentPort()) : simulator.connect();
                scripted(link, i).start();
            }
            simulator.awaitEnd();
            return simulator.report().orElseThrow();
        }
    }

    private static RunReport runOverTcp(List<Integer> numbers) throws Exception {
        try (Simulator simulator = Simulator.start(league(numbers.size(), 7), new RecordingConsole())) {
            for (int number : numbers) {
                scripted(TcpAgentLink.connect("127.0.0.1", simulator.agentPort()), number)
                        .start();
            }
            simulator.awaitEnd();
            return simulator.report().orElseThrow();
        }
    }

    private static String runWithoutSynAtFirst() throws IOException {
        Simulator simulator = Simulator.start(settings(1, 7), new RecordingConsole());
        try (TestAgent agent = new TestAgent(TcpAgentLink.connect("127.0.0.1", simulator.agentPort()))) {
            agent.exchange("(scene rsg/agent/nao/nao.rsg)");
            agent.exchange("(init (unum 1)(teamname Stars))");
            for (int i = 0; i < 50; i++) {
                agent.exchange("(lae1 1)(syn)");
            }
        }
        simulator.close();
        return simulator.report().orElseThrow().recordingSha256();
    }

    private static ScriptedAgent scripted(AgentLink link, int i) {
        return new ScriptedAgent(link, i % 2 == 0 ? "Moons" : "Stars", (i + 1) / 2);
    }

    private static List<Integer> numbers(int count) {
        return new ArrayList<>(IntStream.rangeClosed(1, count).boxed().toList());
    }

    private static String runUntilAgentLeaves() throws IOException {
        Simulator simulator = Simulator.start(settings(1, 7), new RecordingConsole());
        try (TestAgent agent = new TestAgent(simulator.connect())) {
            agent.join("Stars", 1);
            for (int i = 0; i < 50; i++) {
                agent.exchange("(lae1 1)(syn)");
            }
            agent.send("(lae1 0)(syn)");
        }
        simulator.close();
        return simulator.report().orElseThrow().recordingSha256();
    }

    private static SimulatorSettings league(int agents, long seed) {
        return SimulatorSettings.of(WorldSettings.league().withSeed(seed))
                .withAgentPort(0)
                .withSpeed(SimulationControl.AS_FAST_AS_POSSIBLE)
                .withAwaitedAgents(agents)
                .withSeconds(1);
    }

    /** League beams, since their noise depends on the seed. */
    private static SimulatorSettings settings(int agents, long seed) {
        return SimulatorSettings.of(WorldSettings.beginner()
                        .withParameters(SoccerParameters.beginner().with("BeamNoiseXY=0.05"))
                        .withSeed(seed))
                .withAgentPort(0)
                .withSpeed(SimulationControl.AS_FAST_AS_POSSIBLE)
                .withAwaitedAgents(agents)
                .withSeconds(6);
    }
}
