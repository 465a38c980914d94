package org.robonewbie.agent.policy;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class QuantityTest {

    @ParameterizedTest
    @CsvSource({"degrees, 1", "30 degrees, 30", "0.05 m, 0.05", "m/s², 1", "1, 1", "1 or 0, 1"})
    void unitMayHaveAFactor(String unit, double factor) {
        assertThat(new Quantity("gyro.left", unit).factor()).isEqualTo(factor);
    }

    @ParameterizedTest
    @CsvSource({"30, degrees, 30 degrees", "0.05, m, 0.05 m"})
    void factorIsWrittenInFrontOfTheUnit(double factor, String unit, String written) {
        assertThat(Quantity.scaled("gyro.left", factor, unit).unit()).isEqualTo(written);
    }
}
