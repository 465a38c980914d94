package org.robonewbie.agent;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;

class StartPoseTest {

    @Test
    void eachNumberHasAPlaceOfItsOwnInTheOwnHalf() {
        List<StartPose> places =
                IntStream.rangeClosed(1, 11).mapToObj(StartPose::ofNumber).toList();

        for (StartPose one : places) {
            assertThat(one.x()).isNegative();
            assertThat(places)
                    .filteredOn(other -> Math.hypot(one.x() - other.x(), one.y() - other.y()) < 0.5)
                    .containsExactly(one);
        }
    }
}
