package org.robonewbie.programs.process;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;

class ProgressWatchdogTest {

    private static final int TICKS = ProgressWatchdog.SECONDS * 1000 / ProgressWatchdog.TICK_MILLISECONDS;

    private final ProgressWatchdog watchdog = new ProgressWatchdog();

    @Test
    void programThatDoesNotBeginExhaustsItsTime() {
        tick(TICKS - 1);
        boolean before = watchdog.isExhausted();
        tick(1);

        assertThat(before).isFalse();
        assertThat(watchdog.isExhausted()).isTrue();
    }

    @Test
    void progressBeginsTheTimeAgain() {
        tick(TICKS);
        watchdog.begin();
        watchdog.progress();

        tick(TICKS);

        assertThat(watchdog.isExhausted()).isFalse();
    }

    @Test
    void endedProgramHasNoPlace() {
        watchdog.begin();

        watchdog.end();

        assertThat(watchdog.place()).isEmpty();
    }

    private void tick(int ticks) {
        for (int i = 0; i < ticks; i++) {
            watchdog.tick();
        }
    }
}
