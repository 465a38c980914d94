package org.robonewbie.learning.measure;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

class ShippedMotionsTest {

    private static final int TRIALS = 2;

    @ParameterizedTest
    @MethodSource("checks")
    void keepToTheirRuleInEachTrial(MotionCheck check) {
        CheckResult result = CheckResult.of(check, TRIALS);

        assertThat(result.successes())
                .as("%s %s: %s", check.name(), check.rule(), result.outcomes())
                .isEqualTo(result.outcomes().size());
    }

    static List<MotionCheck> checks() {
        return MotionMeasurement.checks().stream()
                .filter(check -> !check.name().endsWith(", straight"))
                .toList();
    }
}
