package org.robonewbie.competition.contest;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Comparator;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;

class RankedTest {

    static Stream<Arguments> rankings() {
        return Stream.of(
                Arguments.of(List.of(3, 1, 2), List.of(1, 2, 3)),
                Arguments.of(List.of(2, 1, 2, 3), List.of(1, 2, 2, 4)),
                Arguments.of(List.of(1, 1, 1), List.of(1, 1, 1)),
                Arguments.of(List.of(1, 2, 2, 3, 3, 3, 4), List.of(1, 2, 2, 4, 4, 4, 7)),
                Arguments.of(List.of(5), List.of(1)),
                Arguments.of(List.of(), List.of()));
    }

    @ParameterizedTest
    @MethodSource("rankings")
    void equalsShareAPlaceAndTheNextOneIsCountedOn(List<Integer> values, List<Integer> ranks) {
        List<Ranked<Integer>> places = Ranked.ranking(values, Comparator.naturalOrder());

        assertThat(places).extracting(Ranked::rank).isEqualTo(ranks);
        assertThat(places)
                .extracting(Ranked::who)
                .isEqualTo(values.stream().sorted().toList());
    }
}
