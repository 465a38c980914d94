package org.robonewbie.trial.batch;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.ByteArrayOutputStream;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class BatchProgressTest {

    private final ByteArrayOutputStream printed = new ByteArrayOutputStream();
    private final PrintStream out = new PrintStream(printed, true, StandardCharsets.UTF_8);
    private double seconds = 1000;

    private BatchProgress progress(int total, int known, boolean terminal) {
        return new BatchProgress("trials", total, known, terminal, out, () -> (long) (seconds * 1e9));
    }

    private String text() {
        return printed.toString(StandardCharsets.UTF_8);
    }

    @Test
    void showsBarRateAndTimeLeft() {
        BatchProgress progress = progress(40, 0, true);

        for (int i = 0; i < 10; i++) {
            seconds += 0.5;
            progress.advance(i == 3);
        }

        assertThat(progress.line())
                .isEqualTo("[=====>              ] 10 of 40 trials, 2.0 per second, 0:15 left, 1 failed");
        assertThat(progress.rate()).isEqualTo(2);
        assertThat(progress.secondsLeft()).isEqualTo(15);
    }

    @Test
    void estimatesFromThisRunOnly() {
        BatchProgress progress = progress(40, 30, true);

        assertThat(progress.line()).isEqualTo("[===============>    ] 30 of 40 trials, 0.0 per minute, 0:00 left");
        seconds += 50;
        progress.advance(false);

        assertThat(progress.line()).isEqualTo("[===============>    ] 31 of 40 trials, 1.2 per minute, 7:30 left");
    }

    @ParameterizedTest
    @CsvSource({"1, 0:39", "90, 58:30", "1000, 10:50:00"})
    void timeIsInMinutesOrHours(double secondsPerJob, String left) {
        BatchProgress progress = progress(40, 0, false);
        seconds += secondsPerJob;

        progress.advance(false);

        assertThat(progress.line()).endsWith(left + " left");
    }

    @Test
    void barIsFullAtTheEnd() {
        BatchProgress progress = progress(1, 0, true);
        seconds += 2;

        progress.advance(false);

        assertThat(progress.line()).isEqualTo("[====================] 1 of 1 trials, 0.5 per second, 0:00 left");
        assertThat(progress(0, 0, true).line()).startsWith("[====================] 0 of 0");
    }

    @Test
    void terminalLineIsRewrittenInPlaceAndRemovedAtTheEnd() {
        BatchProgress progress = progress(4, 0, true);

        progress.advance(false);
        assertThat(text()).isEmpty();
        seconds += 1;
        progress.advance(false);
        assertThat(text()).startsWith("\r[==========>         ] 2 of 4").doesNotContain("\n");
        printed.reset();
        progress.print(out::println, "trial 2 is over");
        assertThat(text()).containsSubsequence("\r   ", "\rtrial 2 is over", "\n", "\r[==========>  ");
        printed.reset();
        progress.close();
        progress.close();

        assertThat(text()).isEqualTo("\r" + " ".repeat(79) + "\r");
    }

    @Test
    void withoutATerminalALineIsPrintedOnceAMinute() {
        BatchProgress progress = progress(200, 0, false);

        for (int i = 0; i < 130; i++) {
            seconds += 1;
            progress.advance(false);
        }
        progress.print(out::println, "over");
        progress.close();

        assertThat(text().lines())
                .containsExactly(
                        "[======>             ] 60 of 200 trials, 1.0 per second, 2:20 left",
                        "[============>       ] 120 of 200 trials, 1.0 per second, 1:20 left",
                        "over");
    }

    @Test
    void isQuietWhereOutputsAreNoTerminal() {
        try (BatchProgress progress = BatchProgress.of("trials", 2, 0)) {
            progress.advance(false);

            assertThat(progress.line()).contains("1 of 2 trials");
        }
    }
}
