package org.robonewbie.agent.running;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.OutputStream;
import java.io.PrintStream;
import java.util.Optional;
import java.util.concurrent.atomic.AtomicInteger;
import org.junit.jupiter.api.Test;
import org.robonewbie.agent.log.Mistakes;
import student.Dreamer;

class WatchdogTest {

    private final Mistakes mistakes = new Mistakes(new PrintStream(OutputStream.nullOutputStream()));
    private final AtomicInteger givenUp = new AtomicInteger();
    private final Watchdog watchdog = new Watchdog(mistakes, Optional.of(givenUp::incrementAndGet));

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
        assertThat(mistakes.reported())
                .anyMatch(line -> line.contains("think() has not returned for 1 s; the robot waits for it."))
                .anyMatch(line -> line.contains("think() has not returned for 5 s; the run ends here."));
    }

    private void dreamFor(int ticks) {
        watchdog.thinkBegins();
        Dreamer.dream(watchdog::tick, ticks);
    }
}
