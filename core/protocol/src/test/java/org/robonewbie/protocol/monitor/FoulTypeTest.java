package org.robonewbie.protocol.monitor;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class FoulTypeTest {

    @ParameterizedTest
    @CsvSource({
        "0, CROWDING",
        "1, TOUCHING",
        "2, ILLEGAL_DEFENCE",
        "3, ILLEGAL_ATTACK",
        "4, INCAPABLE",
        "5, ILLEGAL_KICK_OFF",
        "6, CHARGING",
        "7, SELF_COLLISION",
        "8, BALL_HOLDING",
        "9, DOUBLE_TOUCHING",
        "10, HAND_FOUL"
    })
    void numbersAreThoseOfRoboViz(int number, FoulType type) {
        assertThat(type.simSparkNumber()).isEqualTo(number);
        assertThat(FoulType.ofSimSparkNumber(number)).contains(type);
    }

    @Test
    void otherNumbersMeanNothing() {
        assertThat(FoulType.ofSimSparkNumber(-1)).isEmpty();
        assertThat(FoulType.ofSimSparkNumber(11)).isEmpty();
    }
}
