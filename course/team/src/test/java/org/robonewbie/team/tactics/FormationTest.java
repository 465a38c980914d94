package org.robonewbie.team.tactics;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import org.robonewbie.nao.SoccerField;
import org.robonewbie.nao.geometry.Pose2d;
import org.robonewbie.nao.geometry.Translation2d;

class FormationTest {

    private final Formation formation = new Formation(SoccerField.LEAGUE);

    @Test
    void hasAPlaceForEachPlayer() {
        for (int players = 0; players <= 9; players++) {
            assertThat(formation.places(Translation2d.ORIGIN, players)).hasSize(players);
        }
    }

    @Test
    void smallTeamsFillTheMostImportantPlaces() {
        assertThat(formation.places(Translation2d.ORIGIN, 2).keySet())
                .isEqualTo(formation.places(Translation2d.ORIGIN, 9).keySet().stream()
                        .limit(2)
                        .collect(java.util.stream.Collectors.toSet()));
    }

    @ParameterizedTest
    @ValueSource(doubles = {-15, -7, 0, 7, 15})
    void staysOnThePitchWhereverTheBallIs(double x) {
        for (double y = -10; y <= 10; y += 5) {
            assertThat(formation.places(new Translation2d(x, y), 9).values()).allSatisfy(place -> {
                assertThat(Math.abs(place.x())).isLessThan(15);
                assertThat(Math.abs(place.y())).isLessThan(10);
            });
        }
    }

    @Test
    void keepsPlayersApart() {
        List<Translation2d> places =
                List.copyOf(formation.places(Translation2d.ORIGIN, 9).values());

        for (int i = 0; i < places.size(); i++) {
            for (int j = 0; j < i; j++) {
                assertThat(places.get(i).distanceTo(places.get(j))).isGreaterThan(1);
            }
        }
    }

    @Test
    void leavesTheBallToOnePlayer() {
        assertThat(formation.places(Translation2d.ORIGIN, 9).values())
                .allSatisfy(place -> assertThat(place.length()).isGreaterThan(2.5));
    }

    @ParameterizedTest
    @CsvSource({"true,true", "true,false", "false,true", "false,false"})
    void linesUpInTheOwnHalfOnBothPitches(boolean kicksOff, boolean small) {
        for (SoccerField field : List.of(SoccerField.LEAGUE, SoccerField.BEGINNER)) {
            for (int number = 1; number <= 11; number++) {
                Pose2d place = KickOffPositions.place(number, kicksOff, small, field);
                assertThat(place.x()).isBetween(-field.length() / 2, -0.3);
                assertThat(Math.abs(place.y())).isLessThan(field.width() / 2);
                boolean atBall = kicksOff && (number == 2 || number == 3);
                assertThat(atBall || place.translation().length() > field.centreCircleRadius())
                        .isTrue();
            }
        }
    }
}
