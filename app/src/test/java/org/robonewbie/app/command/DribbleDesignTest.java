package org.robonewbie.app.command;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import java.util.stream.LongStream;
import org.junit.jupiter.api.Test;
import org.robonewbie.learning.search.Search;
import org.robonewbie.learning.search.SearchPlan;
import org.robonewbie.nao.model.RobotType;
import org.robonewbie.team.skill.CloseDribbleNumbers;

/** A short part of the search for dribbling closely, and what came of it. */
class DribbleDesignTest {

    @Test
    void goesTheSameWayEachTime() {
        assertThat(firstGeneration()).isEqualTo(firstGeneration());
    }

    @Test
    void paysMoreForBallsThatRollAway() {
        DribbleTrial close = new DribbleTrial(9, 5, 0.4, false);
        DribbleTrial far = new DribbleTrial(9, 5, 0.6, false);
        DribbleTrial late = new DribbleTrial(10.5, 5, 0.4, false);
        DribbleTrial given = new DribbleTrial(Double.POSITIVE_INFINITY, 4, 0.63, false);

        assertThat(close.cost()).isLessThan(Math.min(far.cost(), late.cost()));
        assertThat(given.cost()).isGreaterThan(Math.max(far.cost(), late.cost()));
        assertThat(close.isClose()).isTrue();
        assertThat(far.isClose()).isFalse();
        assertThat(late.isClose()).isFalse();
    }

    @Test
    void keepsTheBallNearOnMostWays() {
        long near = LongStream.rangeClosed(1, 4)
                .filter(seed -> DribbleTrial.served(RobotType.TYPE_0, CloseDribbleNumbers.FOUND, seed)
                        .isClose())
                .count();

        assertThat(near).isGreaterThanOrEqualTo(2);
    }

    private static List<Double> firstGeneration() {
        List<Double> costs = new ArrayList<>();
        new Search(new SearchPlan(5, 0.2, 4, 1, 1, 1), new DribbleDesign())
                .run(CloseDribbleNumbers.coordinates(), progress -> costs.add(progress.meanCost()));
        return costs;
    }
}
