package org.robonewbie.agent.log;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.ByteArrayOutputStream;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import org.junit.jupiter.api.Test;

class LoggerTest {

    private final Logger log = new Logger("Striker", 3);

    @Test
    void printsLinesWithTimeAndLevel() {
        log.setTime(12.34);
        log.info("ball at %.2f m", 1.2);
        log.setTime(12.36);
        log.warning("two\nlines");

        assertThat(printed()).isEqualTo("""
                        --- log of Striker ---
                           12.34  INFO     ball at 1.20 m
                           12.36  WARNING  two
                                           lines
                        --- end of the log ---
                        """);
    }

    @Test
    void keepsTheNewestLinesAndTellsHowManyAreGone() {
        for (int i = 1; i <= 5; i++) {
            log.info("line %d", i);
        }

        assertThat(printed())
                .contains("(the first 2 lines are gone: more than 3 were written)")
                .contains("line 3")
                .doesNotContain("line 2");
    }

    @Test
    void printsNothingTwice() {
        log.info("once");

        printed();

        assertThat(printed()).isEmpty();
    }

    @Test
    void leavesOutWhatIsLessImportantThanItsLevel() {
        log.debug("usually not");
        log.setLevel(LogLevel.WARNING);
        log.info("not now");
        log.error("this");

        assertThat(log.lines()).extracting(LogLine::text).containsExactly("this");
    }

    @Test
    void takesTextsWithPercentSignsAndWrongPatternsAsTheyAre() {
        log.info("100%");
        log.info("%d goals", "two");

        assertThat(log.lines()).extracting(LogLine::text).containsExactly("100%", "%d goals [two]");
    }

    private String printed() {
        ByteArrayOutputStream bytes = new ByteArrayOutputStream();
        log.print(new PrintStream(bytes, true, StandardCharsets.UTF_8));
        return bytes.toString(StandardCharsets.UTF_8).replace(System.lineSeparator(), "\n");
    }
}
