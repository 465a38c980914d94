package org.robonewbie.learning.measure;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

class ShippedMotionsTest {

    /** What is measured in trials that another check judges already. */
    private static final List<String> SECOND_LOOKS = List.of(", straight", ", drift", "place, mostly", ", heading");

    /** Falls in two of twenty long runs, as the documents say; {@code LearnedWalkTest} holds what it does over 10 m. */
    private static final String NOT_IN_EACH_TRIAL = "learned run";

    @ParameterizedTest
    @MethodSource("checks")
    void keepToTheirRule(MotionCheck check) {
        keepToTheirRule(check, 1);
    }

    @Tag("slow")
    @ParameterizedTest
    @MethodSource("checks")
    void keepToTheirRuleInEachTrial(MotionCheck check) {
        keepToTheirRule(check, 3);
    }

    private static void keepToTheirRule(MotionCheck check, int trials) {
        CheckResult result = CheckResult.of(check, trials);

        assertThat(result.successes())
                .as("%s %s: %s", check.name(), check.rule(), result.outcomes())
                .isEqualTo(result.outcomes().size());
    }

    static List<MotionCheck> checks() {
        return MotionMeasurement.checks().stream()
                .filter(check -> !check.name().startsWith(NOT_IN_EACH_TRIAL))
                .filter(check -> SECOND_LOOKS.stream().noneMatch(check.name()::endsWith))
                .toList();
    }
}
