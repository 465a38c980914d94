package org.robonewbie.agent.running;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.OutputStream;
import java.io.PrintStream;
import java.lang.management.ManagementFactory;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.function.BooleanSupplier;
import org.junit.jupiter.api.Test;
import org.robonewbie.agent.log.Diagnostics;
import student.Dreamer;

class WatchdogTest {

    private final Diagnostics diagnostics = new Diagnostics(new PrintStream(OutputStream.nullOutputStream()));
    private final AtomicInteger givenUp = new AtomicInteger();
    private final List<Slowness> heard = new ArrayList<>();
    private long nanoseconds;
    private final Watchdog watchdog = watchdog(CycleOwner.FRAMEWORK);

    @Test
    void saysInWhichLineALateCycleSpentItsTime() {
        dreamFor(4);

        assertThat(watchdog.slowPlace()).matches("Dreamer\\.java:\\d+");
    }

    @Test
    void forgetsThePlaceWithTheNextThought() {
        dreamFor(4);
        watchdog.thinkEnds();
        watchdog.thinkBegins();

        assertThat(watchdog.slowPlace()).isEmpty();
    }

    @Test
    void knowsNoPlaceInAQuickThought() {
        dreamFor(1);

        assertThat(watchdog.slowPlace()).isEmpty();
    }

    @Test
    void reportsAThoughtThatDoesNotEndAndGivesUp() {
        dreamFor(6 * 500 + 2);

        assertThat(givenUp).hasPositiveValue();
        assertThat(diagnostics.reported())
                .anyMatch(line -> line.contains("think() has not returned for 1 s; the robot waits for it."))
                .anyMatch(line -> line.contains("think() has not returned for 5 s; the run ends here."));
    }

    @Test
    void namesTheLineOfAProgramThatTurnsTheCycleItself() {
        Watchdog other = watchdog(CycleOwner.PROGRAM);
        other.thinkBegins();
        computeUntil(other, () -> !diagnostics.reported().isEmpty());

        assertThat(diagnostics.reported().get(0))
                .contains("The program has not called sense() for 1 s; the robot waits for it.")
                .containsPattern("\\(Dreamer\\.java:\\d+\\)$");
        assertThat(heard).isEmpty();
    }

    @Test
    void namesTheLineInWhichManyThoughtsCompute() {
        for (int i = 0; i < 5; i++) {
            watchdog.thinkBegins();
            Dreamer.dream(watchdog::tick, 2);
            long end = workedMilliseconds() + 70;
            Dreamer.dreamUntil(() -> workedMilliseconds() > end);
            Dreamer.dream(watchdog::tick, 1);
            nanoseconds += 300_000_000;
            watchdog.thinkEnds();
        }
        watchdog.thinkBegins();

        assertThat(heard).singleElement().matches(slowness -> !slowness.isIdle());
        assertThat(diagnostics.reported())
                .singleElement()
                .asString()
                .matches("0\\.00 s: think\\(\\) took about 300 ms; it is called 50 times per simulated second\\."
                        + " Compute less in a cycle, or spread the work over several cycles\\."
                        + " \\(Dreamer\\.java:\\d+\\)");
    }

    @Test
    void takesAPauseThatNobodyComputesInForADebugger() {
        for (int i = 0; i < 20; i++) {
            dreamFor(10);
            nanoseconds += 3_000_000_000L;
            watchdog.thinkEnds();
        }
        watchdog.thinkBegins();

        assertThat(diagnostics.reported()).isEmpty();
    }

    private Watchdog watchdog(CycleOwner owner) {
        return new Watchdog(owner, diagnostics, Optional.of(givenUp::incrementAndGet), heard::add, () -> nanoseconds);
    }

    private static void computeUntil(Watchdog watchdog, BooleanSupplier end) {
        Dreamer.dreamUntil(() -> {
            watchdog.tick();
            return end.getAsBoolean();
        });
    }

    private static long workedMilliseconds() {
        return ManagementFactory.getThreadMXBean().getCurrentThreadCpuTime() / 1_000_000;
    }

    private void dreamFor(int ticks) {
        watchdog.thinkBegins();
        Dreamer.dream(watchdog::tick, ticks);
    }
}
