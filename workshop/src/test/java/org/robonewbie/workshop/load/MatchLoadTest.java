package org.robonewbie.workshop.load;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.OutputStream;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.util.List;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

@Timeout(120)
class MatchLoadTest {

    @Test
    void matchesAreCountedFromKickOffToTheEndOfTheSecondHalf() throws IOException {
        ByteArrayOutputStream progress = new ByteArrayOutputStream();
        MatchLoad load = new MatchLoad(
                new LoadSettings(4, 4, 2, false), new PrintStream(progress, true, StandardCharsets.UTF_8));

        List<MatchLoadResult> results = load.run();

        assertThat(results).extracting(MatchLoadResult::match).containsExactly(1, 2);
        assertThat(results).allSatisfy(result -> {
            assertThat(result.playSeconds()).isCloseTo(4, within(0.1));
            assertThat(result.cycles()).isPositive();
            assertThat(result.missedCycles()).isZero();
            assertThat(result.serverMilliseconds()).isPositive().isLessThan(result.processMilliseconds());
            assertThat(result.heapMegabytes()).isPositive();
        });
    }

    @Tag("slow")
    @Test
    void onTheClockAMatchTakesItsTime() throws IOException {
        long start = System.nanoTime();

        List<MatchLoadResult> results =
                new MatchLoad(new LoadSettings(2, 2, 1, true), new PrintStream(OutputStream.nullOutputStream())).run();

        assertThat((System.nanoTime() - start) / 1e9).isGreaterThan(1.9);
        assertThat(results).hasSize(1);
    }

    @Test
    void arrivalsTellHowFarFromTwentyMillisecondsTheyAre() {
        Arrivals arrivals = new Arrivals();

        arrivals.add(0, 1.00);
        arrivals.add(20_000_000, 1.02);
        arrivals.add(43_000_000, 1.04);
        arrivals.add(60_000_000, 1.06);
        arrivals.add(900_000_000, 1.50);

        assertThat(arrivals.deviationSeconds(1)).isCloseTo(0.003, within(1e-9));
        assertThat(arrivals.deviationSeconds(0.5)).isCloseTo(0.003, within(1e-9));
        assertThat(arrivals.deviationSeconds(0)).isCloseTo(0, within(1e-9));
    }

    @Test
    void theLineFitsToTheTitle() {
        MatchLoadResult result = new MatchLoadResult(1, 30_250, 600, 0, 4.25, 6.5, 0.31, 4.5, 20.5);

        assertThat(result.toLine()).hasSameSizeAs(MatchLoadResult.TITLE);
    }
}
