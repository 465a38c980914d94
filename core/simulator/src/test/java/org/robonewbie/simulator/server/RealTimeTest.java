package org.robonewbie.simulator.server;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.concurrent.BlockingQueue;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.robonewbie.protocol.tcp.TcpAgentLink;
import org.robonewbie.simulator.WorldSnapshot;
import org.robonewbie.simulator.cycle.WorldSettings;

@Timeout(120)
class RealTimeTest {

    private final HandTurnedClock clock = new HandTurnedClock();

    @Test
    void worldKeepsStepWithTheClock() {
        Pacemaker pacemaker = new Pacemaker(1, clock::nanoseconds, clock::advanceTo);

        cycles(pacemaker, 100);

        assertThat(clock.milliseconds()).isEqualTo(2000);
        assertThat(pacemaker.missedCycles()).isZero();
        assertThat(pacemaker.realTimeFactor()).isCloseTo(1, within(0.05));
    }

    @Test
    void slowMotionTakesAsMuchLonger() {
        Pacemaker pacemaker = new Pacemaker(0.25, clock::nanoseconds, clock::advanceTo);

        cycles(pacemaker, 10);

        assertThat(clock.milliseconds()).isEqualTo(800);
    }

    @Test
    void timeOfACycleIsNotAddedToWhatItTook() {
        Pacemaker pacemaker = new Pacemaker(1, clock::nanoseconds, clock::advanceTo);

        for (int i = 0; i < 10; i++) {
            pacemaker.awaitNextCycle();
            clock.pass(15);
        }

        assertThat(clock.milliseconds()).isEqualTo(215);
    }

    @Test
    void timeIsDroppedInsteadOfHurriedWhenTheWorldIsTooSlow() {
        Pacemaker pacemaker = new Pacemaker(1, clock::nanoseconds, clock::advanceTo);

        pacemaker.awaitNextCycle();
        clock.pass(1000);
        cycles(pacemaker, 11);

        assertThat(pacemaker.missedCycles()).isEqualTo(49);
        assertThat(clock.milliseconds()).isEqualTo(1220);
    }

    @Test
    void cyclesAreNotMissedWhileTheWorldIsMeantToStandStill() {
        Pacemaker pacemaker = new Pacemaker(1, clock::nanoseconds, clock::advanceTo);

        pacemaker.awaitNextCycle();
        clock.pass(60);
        pacemaker.pause();
        pacemaker.awaitNextCycle();

        assertThat(pacemaker.missedCycles()).isZero();
    }

    @Test
    void slowAgentLosesCyclesAndTheReportTellsIt() throws Exception {
        BlockingQueue<WorldSnapshot> cycles = new LinkedBlockingQueue<>();
        Simulator simulator = Simulator.start(
                SimulatorSettings.of(WorldSettings.beginner().withSynchronous(false))
                        .withAgentPort(0),
                new RecordingConsole());
        try (TestAgent agent = new TestAgent(TcpAgentLink.connect("127.0.0.1", simulator.agentPort()))) {
            agent.joinRunningGame("Stars", 1);
            simulator.control().addObserver(cycles::add);
            for (int i = 0; i < 3; i++) {
                awaitCycle(cycles, simulator.cycles() + 8);
                agent.exchange("(syn)");
            }
        }
        simulator.close();

        assertThat(simulator.report().orElseThrow().robots().get(0).missedCycles())
                .isGreaterThan(15);
    }

    private static void cycles(Pacemaker pacemaker, int count) {
        for (int i = 0; i < count; i++) {
            pacemaker.awaitNextCycle();
        }
    }

    /** Does not answer while the world goes on, however slow the computer is. */
    private static void awaitCycle(BlockingQueue<WorldSnapshot> cycles, long cycle) throws InterruptedException {
        long reached = cycles.take().cycle();
        while (reached < cycle) {
            reached = cycles.take().cycle();
        }
    }

    /** A clock that goes on only when it is waited for or turned. */
    private static final class HandTurnedClock {

        private long nanoseconds = 1_000_000;

        private long nanoseconds() {
            return nanoseconds;
        }

        private void advanceTo(long moment) {
            nanoseconds = Math.max(nanoseconds, moment);
        }

        private void pass(int milliseconds) {
            nanoseconds += TimeUnit.MILLISECONDS.toNanos(milliseconds);
        }

        private long milliseconds() {
            return TimeUnit.NANOSECONDS.toMillis(nanoseconds) - 1;
        }
    }
}
