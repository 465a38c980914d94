package org.robonewbie.simulator.server;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.io.IOException;
import java.time.Duration;
import java.util.List;
import java.util.Set;
import java.util.TreeSet;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.LinkedBlockingQueue;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.robonewbie.protocol.perceptor.PerceptorMessage;
import org.robonewbie.protocol.tcp.TcpAgentLink;
import org.robonewbie.simulator.SimulationControl;
import org.robonewbie.simulator.cycle.WorldSettings;

@Timeout(120)
class SyncModeTest {

    private final RecordingConsole console = new RecordingConsole();

    @Test
    void worldWaitsForEachAnswer() throws Exception {
        try (Simulator simulator = start(60);
                TestAgent agent = agent(simulator)) {
            agent.join("Stars", 1);
            double before = agent.exchange("(syn)").seconds().orElseThrow();

            awaitStandingWorld(simulator);
            double after = agent.exchange("(syn)").seconds().orElseThrow();

            assertThat(after - before).isCloseTo(0.02, within(1e-9));
        }
    }

    @Test
    void messagesFollowEachOtherWithoutGap() throws IOException {
        try (Simulator simulator = start(60);
                TestAgent agent = agent(simulator)) {
            double last = agent.join("Stars", 1).seconds().orElseThrow();

            for (int i = 0; i < 100; i++) {
                double now = agent.exchange("(syn)").seconds().orElseThrow();
                assertThat(now - last).isCloseTo(0.02, within(1e-9));
                last = now;
            }
        }
    }

    @Test
    void lastAnswerOfAnAgentThatHasEndedCountsHoweverSoonTheSimulatorIsClosed() throws IOException {
        Set<Long> cycles = new TreeSet<>();
        for (int i = 0; i < 40; i++) {
            Simulator simulator = start(60);
            try (TestAgent agent = agent(simulator)) {
                agent.join("Stars", 1);
                agent.send("(he1 1)(syn)");
            } finally {
                simulator.close();
            }
            cycles.add(simulator.cycles());
        }

        assertThat(cycles).hasSize(1);
    }

    @Test
    void silentAgentIsNamedAndDroppedSoThatTheOthersGoOn() throws IOException {
        try (Simulator simulator = start(0.3);
                TestAgent silent = agent(simulator);
                TestAgent lively = agent(simulator)) {
            CompletableFuture<Void> played = CompletableFuture.runAsync(() -> playTenCycles(silent));
            lively.join("Stars", 1);
            while (!played.isDone()) {
                lively.exchange("(syn)");
            }

            for (int i = 0; i < 20; i++) {
                lively.exchange("(syn)");
            }

            assertThat(console.sentences())
                    .anyMatch(sentence -> sentence.startsWith("Disconnected player 2 of Stars")
                            && sentence.contains("not answered for"));
        }
    }

    @Tag("slow")
    @Test
    void fiveWhoJoinAndFallSilentCostTheOthersNoMoreThanOne() throws IOException {
        try (Simulator simulator = start(3);
                TestAgent lively = agent(simulator)) {
            lively.join("Stars", 1);
            for (int i = 0; i < 100; i++) {
                lively.exchange("(syn)");
            }

            for (int i = 0; i < 5; i++) {
                joinAndFallSilent(simulator, lively);
            }

            List<Double> standstills = console.sentences().stream()
                    .filter(sentence -> sentence.startsWith("Disconnected"))
                    .map(sentence -> Double.valueOf(sentence.replaceAll("^.* for ([0-9.]+) s\\.$", "$1")))
                    .toList();
            assertThat(standstills).hasSize(5);
            assertThat(standstills.stream().mapToDouble(Double::doubleValue).sum())
                    .isBetween(1.0, 3.0);
        }
    }

    private static void joinAndFallSilent(Simulator simulator, TestAgent lively) throws IOException {
        try (TestAgent mute = agent(simulator)) {
            CompletableFuture<PerceptorMessage> joined = CompletableFuture.supplyAsync(() -> join(mute, 2));
            while (!joined.isDone()) {
                lively.exchange("(syn)");
            }
            for (int i = 0; i < 20; i++) {
                lively.exchange("(syn)");
            }
        }
    }

    @Test
    void robotOfTheOnlyAgentLeavesWithItThoughTheWorldStillWaitsForAnAnswer() throws Exception {
        try (Simulator simulator = start(60)) {
            TestAgent agent = new TestAgent(simulator.connect());
            agent.join("Stars", 1);

            agent.close();

            CompletableFuture<Boolean> gone = new CompletableFuture<>();
            simulator.control().addObserver(snapshot -> {
                if (snapshot.robots().isEmpty()) {
                    gone.complete(true);
                }
            });
            assertThat(gone).succeedsWithin(Duration.ofSeconds(60));
        }
    }

    @Test
    void agentMayJoinWithoutSyn() throws IOException {
        try (Simulator simulator = start(60);
                TestAgent agent = agent(simulator)) {
            agent.exchange("(scene rsg/agent/nao/nao.rsg)");

            PerceptorMessage message = agent.exchange("(init (unum 1)(teamname Stars))");

            assertThat(message.seconds()).isPresent();
        }
    }

    @Test
    void messageWithoutSynKeepsTheWorldWaiting() throws IOException {
        try (Simulator simulator = start(60);
                TestAgent agent = agent(simulator)) {
            agent.join("Stars", 1);
            double before = 0;
            for (int i = 0; i < 5; i++) {
                before = agent.exchange("(syn)").seconds().orElseThrow();
            }

            agent.send("(he1 1)");
            agent.send("(he1 0)");
            double after = agent.exchange("(syn)").seconds().orElseThrow();

            assertThat(after - before).isCloseTo(0.02, within(1e-9));
        }
    }

    @Test
    void portInUseIsExplained() throws IOException {
        try (Simulator simulator = start(60)) {
            SimulatorSettings same = SimulatorSettings.of(WorldSettings.league().withSynchronous(false))
                    .withAgentPort(simulator.agentPort());

            assertThatThrownBy(() -> Simulator.start(same, console))
                    .isInstanceOf(IOException.class)
                    .hasMessageContaining("Port " + simulator.agentPort() + " on 127.0.0.1 cannot be opened")
                    .hasMessageContaining("Stop it, or choose another port with --agent-port.");
        }
    }

    /** Takes as long as a slow thought: until the server has looked for an answer twice in vain. */
    private static void awaitStandingWorld(Simulator simulator) throws InterruptedException {
        BlockingQueue<Long> cycles = new LinkedBlockingQueue<>();
        simulator.control().addObserver(snapshot -> cycles.add(snapshot.cycle()));
        long last = cycles.take();
        for (int equal = 1; equal < 3; ) {
            long next = cycles.take();
            equal = next == last ? equal + 1 : 1;
            last = next;
        }
    }

    private Simulator start(double silentAgentSeconds) throws IOException {
        return Simulator.start(
                SimulatorSettings.of(WorldSettings.beginner())
                        .withAgents(new SimulatorSettings.Agents(
                                SimulatorSettings.LOCALHOST, 0, List.of(), 1, silentAgentSeconds))
                        .withSpeed(SimulationControl.AS_FAST_AS_POSSIBLE),
                console);
    }

    private static TestAgent agent(Simulator simulator) throws IOException {
        return new TestAgent(TcpAgentLink.connect("127.0.0.1", simulator.agentPort()));
    }

    private static void playTenCycles(TestAgent agent) {
        try {
            agent.join("Stars", 2);
            for (int i = 0; i < 10; i++) {
                agent.exchange("(syn)");
            }
        } catch (IOException e) {
            throw new IllegalStateException(e);
        }
    }

    private static PerceptorMessage join(TestAgent agent, int number) {
        try {
            return agent.join("Stars", number);
        } catch (IOException e) {
            throw new IllegalStateException(e);
        }
    }
}
