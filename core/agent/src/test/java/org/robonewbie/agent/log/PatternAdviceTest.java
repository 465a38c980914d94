package org.robonewbie.agent.log;

import static org.assertj.core.api.Assertions.assertThat;
import static org.junit.jupiter.params.provider.Arguments.arguments;

import java.util.ArrayList;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;

class PatternAdviceTest {

    private final RunLog log = new RunLog("Writer");
    private final List<String> advice = new ArrayList<>();

    static Stream<Arguments> wrongPatterns() {
        return Stream.of(
                wrong("%d is for whole numbers; use %.1f for 1.5, in \"angle %d\".", "angle %d", 1.5),
                wrong("%5x is for whole numbers; use %.1f for 0.0, in \"%5x\".", "%5x", -0.0),
                wrong("%d is for whole numbers; use %s for \"left\", in \"%d\".", "%d", "left"),
                wrong("%d is for whole numbers; use %s for \"true\", in \"%s %d\".", "%s %d", 1, true),
                wrong("%.1d has no digits after the point; use %d for 3, in \"%.1d\".", "%.1d", 3),
                wrong("%.1d is for whole numbers; use %.1f for 3.5, in \"%.1d\".", "%.1d", 3.5),
                wrong("%.2f is for decimal numbers; use %d for 3, in \"%.2f m\".", "%.2f m", 3),
                wrong("%f is for decimal numbers; use %d for 7, in \"%f\".", "%f", 7L),
                wrong("%e is for decimal numbers; use %s for \"x\", in \"%e\".", "%e", "x"),
                wrong("%c is for one letter; use %s for \"ab\", in \"%c\".", "%c", "ab"),
                wrong(
                        "There is no value for %s: pass one more value, or remove the placeholder; %% writes a per"
                                + " cent sign, in \"%s %s\".",
                        "%s %s", 1),
                wrong(
                        "There is no value for %3$s: pass one more value, or remove the placeholder; %% writes a"
                                + " per cent sign, in \"%3$s\".",
                        "%3$s", 1, 2),
                wrong(
                        "%k is unknown: %d is for whole numbers, %.1f for other numbers, %s for texts; %% writes a per cent"
                                + " sign, in \"%k\".",
                        "%k", 1),
                wrong("A lone % shows nothing; %% writes a per cent sign, in \"%d %\".", "%d %", 50),
                wrong("A lone % shows nothing; %% writes a per cent sign, in \"%d % of\".", "%d % of", 50),
                wrong("A lone % shows nothing; %% writes a per cent sign, in \"%d %, ok\".", "%d %, ok", 50),
                wrong("A lone % shows nothing; %% writes a per cent sign, in \"% done %s\".", "% done %s", 50),
                wrong(
                        "The text \"angle\" lacks placeholders: write %.1f or %s where each value should appear.",
                        "angle", 50));
    }

    @ParameterizedTest
    @MethodSource("wrongPatterns")
    void saysWhatToWriteAndShowsTheTextAllTheSame(String sentence, String pattern, Object[] values) {
        log.setPatternListener(text -> advice.add(text.get()));

        log.info(pattern, values);

        assertThat(advice).containsExactly(sentence);
        assertThat(log.lines())
                .singleElement()
                .extracting(LogLine::text)
                .asString()
                .startsWith(pattern + " [");
    }

    @Test
    void isSilentAboutPatternsThatFit() {
        log.setPatternListener(text -> advice.add(text.get()));

        log.info("100 % and %d");
        log.info("%d %5.2f %s %c %% %n %b %x %+d %2$.1f %1$s", 1, 2.0, "x", 'c', true, 255, 3);
        log.debug("%d", 1.5);

        assertThat(advice).isEmpty();
    }

    private static Arguments wrong(String sentence, String pattern, Object... values) {
        return arguments(sentence, pattern, values);
    }
}
