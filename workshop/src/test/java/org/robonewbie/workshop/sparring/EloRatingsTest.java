package org.robonewbie.workshop.sparring;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import org.junit.jupiter.api.Test;

class EloRatingsTest {

    @Test
    void threeWinsOfFourAre191PointsButForThePrior() {
        List<SparringMatch.Result> results = new ArrayList<>();
        for (int i = 0; i < 400; i++) {
            results.add(result(SparringTeam.KICKERS, i % 4 == 0 ? -1 : 1));
        }

        var ratings = EloRatings.of(results);

        assertThat(rating(ratings, SparringTeam.TEAM).points()
                        - rating(ratings, SparringTeam.KICKERS).points())
                .isCloseTo(191, within(3.0));
        assertThat(rating(ratings, SparringTeam.TEAM).error()).isBetween(15.0, 25.0);
    }

    @Test
    void aTeamThatWinsEachMatchHasAFiniteRating() {
        var ratings = EloRatings.of(List.of(result(SparringTeam.PACK, 2), result(SparringTeam.PACK, 1)));

        assertThat(rating(ratings, SparringTeam.TEAM).points()).isBetween(50.0, 400.0);
        assertThat(rating(ratings, SparringTeam.PACK).points()).isBetween(-400.0, -50.0);
    }

    @Test
    void drawsMakeTeamsEqual() {
        var ratings = EloRatings.of(List.of(result(SparringTeam.WALL, 0), result(SparringTeam.WALL, 0)));

        assertThat(rating(ratings, SparringTeam.TEAM).points()).isZero();
    }

    private static EloRatings.Rating rating(Map<SparringTeam, EloRatings.Rating> ratings, SparringTeam team) {
        return Objects.requireNonNull(ratings.get(team));
    }

    private static SparringMatch.Result result(SparringTeam other, int lead) {
        TeamFigures first = new TeamFigures();
        TeamFigures second = new TeamFigures();
        first.add(Figure.GOALS, Math.max(0, lead));
        second.add(Figure.GOALS, Math.max(0, -lead));
        return new SparringMatch.Result(new SparringMatch(SparringTeam.TEAM, other, 1, 3, 300), first, second);
    }
}
