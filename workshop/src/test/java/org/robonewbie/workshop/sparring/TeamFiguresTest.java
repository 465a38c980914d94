package org.robonewbie.workshop.sparring;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;

class TeamFiguresTest {

    @Test
    void textKeepsAllFigures() {
        TeamFigures figures = new TeamFigures();
        figures.add(Figure.KICKED_METRES, 12.3456);
        figures.addSpeed(0.7);

        TeamFigures read = TeamFigures.of(figures.toString());

        assertThat(read.get(Figure.KICKED_METRES)).isEqualTo(12.3456);
        assertThat(read).hasToString(figures.toString());
    }

    @Test
    void refusesFiguresOfAnotherVersion() {
        assertThatThrownBy(() -> TeamFigures.of("1 2 3")).hasMessageContaining("but found 3");
    }

    @Test
    void speedsHaveMedianAndQuantile() {
        TeamFigures figures = new TeamFigures();
        for (int i = 0; i < 100; i++) {
            figures.addSpeed(0.01 * i);
        }

        assertThat(figures.speed(0.5)).isCloseTo(0.5, within(0.011));
        assertThat(figures.speed(0.9)).isCloseTo(0.9, within(0.011));
    }

    @Test
    void sumsAddUp() {
        TeamFigures sum = new TeamFigures();
        TeamFigures half = new TeamFigures();
        half.add(Figure.KICKS, 4);
        half.add(Figure.KICKED_METRES, 10);
        sum.add(half);
        sum.add(half);

        assertThat(sum.get(Figure.KICKS)).isEqualTo(8);
        assertThat(sum.ratio(Figure.KICKED_METRES, Figure.KICKS)).isEqualTo(2.5);
    }
}
