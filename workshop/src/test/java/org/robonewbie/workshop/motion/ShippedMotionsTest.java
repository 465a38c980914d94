package org.robonewbie.workshop.motion;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

class ShippedMotionsTest {

    /** What is measured in trials that another check judges already. */
    private static final List<String> SECOND_LOOKS = List.of(", straight", ", drift", "place, mostly", ", heading");

    /**
     * What does not succeed in each trial, as the documents say: the run falls in some of twenty long ways ({@code LearnedWalkTest} holds
     * what it does over 10 m), and the jog still rocks after some of its stops.
     */
    private static final List<String> NOT_IN_EACH_TRIAL =
            List.of("learned run 20 m", "learned run 20 m, stop", "learned jog 20 m, stop");

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
        CheckResult result = CheckResult.of(check, 0, trials);

        assertThat(result.successes())
                .as("%s %s: %s", check.name(), check.rule(), result.outcomes())
                .isEqualTo(result.outcomes().size());
    }

    static List<MotionCheck> checks() {
        return MotionMeasurement.checks().stream()
                .filter(check -> !NOT_IN_EACH_TRIAL.contains(check.name()))
                .filter(check -> SECOND_LOOKS.stream().noneMatch(check.name()::endsWith))
                .toList();
    }
}
