package org.robonewbie.simulator.server;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.io.IOException;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.robonewbie.protocol.frame.TcpAgentLink;

@Timeout(60)
class RealTimeTest {

    @Test
    void worldKeepsStepWithTheClock() throws Exception {
        try (Simulator simulator = start();
                TestAgent agent = agent(simulator)) {
            double start = agent.joinRunningGame("Stars", 1).seconds().orElseThrow();
            long missedBefore = simulator.missedCycles();
            long beginning = System.nanoTime();

            double now = start;
            while (now < start + 1) {
                now = agent.exchange("(syn)").seconds().orElseThrow();
            }

            double realSeconds = (System.nanoTime() - beginning) / 1e9;
            double lostSeconds = (simulator.missedCycles() - missedBefore) * 0.02;
            assertThat(realSeconds).isGreaterThan(0.95);
            assertThat(realSeconds - lostSeconds).isLessThan(1.5);
        }
    }

    @Test
    void slowAgentLosesCyclesAndTheReportTellsIt() throws Exception {
        Simulator simulator = start();
        try (TestAgent agent = agent(simulator)) {
            agent.joinRunningGame("Stars", 1);
            for (int i = 0; i < 3; i++) {
                sleepUntil(simulator, simulator.cycles() + 8);
                agent.exchange("(syn)");
            }
        }
        simulator.close();

        assertThat(simulator.report().orElseThrow().robots().get(0).missedCycles())
                .isGreaterThan(15);
    }

    @Test
    void timeIsDroppedInsteadOfHurriedWhenTheWorldIsTooSlow() {
        Pacemaker pacemaker = new Pacemaker(1000);
        long beginning = System.nanoTime();

        pacemaker.awaitNextCycle();
        busy(5);
        for (int i = 0; i < 100; i++) {
            pacemaker.awaitNextCycle();
        }

        assertThat(pacemaker.missedCycles()).isGreaterThan(100);
        assertThat((System.nanoTime() - beginning) / 1e9).isGreaterThan(0.0065);
    }

    @Test
    void cyclesAreNotMissedWhileTheWorldIsMeantToStandStill() {
        Pacemaker pacemaker = new Pacemaker(1);

        pacemaker.awaitNextCycle();
        busy(60);
        pacemaker.excuse();
        pacemaker.awaitNextCycle();

        assertThat((double) pacemaker.missedCycles()).isCloseTo(0, within(0.0));
    }

    /** Does not answer while the world goes on, however slow the computer is. */
    private static void sleepUntil(Simulator simulator, long cycle) {
        while (simulator.cycles() < cycle) {
            Thread.onSpinWait();
        }
    }

    private static void busy(int milliseconds) {
        long end = System.nanoTime() + milliseconds * 1_000_000L;
        while (System.nanoTime() < end) {
            Thread.onSpinWait();
        }
    }

    private static Simulator start() throws IOException {
        return Simulator.start(SimulatorSettings.beginner().agentPort(0).build(), new RecordingConsole());
    }

    private static TestAgent agent(Simulator simulator) throws IOException {
        return new TestAgent(TcpAgentLink.connect("127.0.0.1", simulator.agentPort()));
    }
}
