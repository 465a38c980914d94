package org.robonewbie.agent.log;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.ByteArrayOutputStream;
import java.io.PrintStream;
import java.lang.management.ManagementFactory;
import java.lang.management.ThreadMXBean;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.junit.jupiter.api.Test;
import org.robonewbie.agent.running.LogFile;

class LoggerTest {

    private final RunLog log = new RunLog("Striker", 3);

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
    void losesNothingWhenTheMemoryIsFullButKeepsTheOldestLinesInAFile() throws Exception {
        log.setOverflow(new LogFile());
        for (int i = 1; i <= 5; i++) {
            log.info("line %d", i);
        }

        String printed = printed();

        assertThat(printed).contains("line 4").contains("line 5").doesNotContain("line 3");
        Matcher note = Pattern.compile("\\(the first 3 lines are in (.+)\\)").matcher(printed);
        assertThat(note.find()).isTrue();
        Path file = Path.of(note.group(1));
        assertThat(file).content().contains("line 1").contains("line 3");
        Files.delete(file);
    }

    @Test
    void tenThousandMessagesPerMinuteCostLessThanAMillisecondPerCycle() {
        Logger busy = new RunLog("Chatterbox");
        for (int i = 0; i < 20_000; i++) {
            busy.info("warm up %d: ball at %.2f m", i, 1.2);
        }

        ThreadMXBean work = ManagementFactory.getThreadMXBean();
        long start = work.getCurrentThreadCpuTime();
        for (int i = 0; i < 10_000; i++) {
            busy.info("%d: ball at %.2f m", i, 1.2);
        }
        double millisecondsPerCycle = (work.getCurrentThreadCpuTime() - start) / 1e6 / (60 * 50);

        assertThat(millisecondsPerCycle).isLessThan(1);
    }

    @Test
    void writesNumbersTheSameInEachCountry() {
        Locale usual = Locale.getDefault();
        Locale.setDefault(Locale.GERMANY);
        try {
            log.setTime(0.5);
            log.info("ball at %.2f m", 1.2);
        } finally {
            Locale.setDefault(usual);
        }

        assertThat(printed()).contains("0.50  INFO     ball at 1.20 m");
    }

    @Test
    void somebodyCanReadAlong() {
        List<String> read = new ArrayList<>();
        log.setListener(line -> read.add(line.level() + " " + line.text()));

        log.debug("too unimportant");
        log.info("ball at %.2f m", 1.2);

        assertThat(read).containsExactly("INFO ball at 1.20 m");
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
