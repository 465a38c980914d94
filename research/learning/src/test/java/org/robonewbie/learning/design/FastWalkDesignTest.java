package org.robonewbie.learning.design;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.robonewbie.agent.walk.FastWalk;
import org.robonewbie.agent.walk.WalkStyle;
import org.robonewbie.learning.search.Search;
import org.robonewbie.learning.search.SearchPlan;

/** A short part of the search that has led to the fast walk. */
class FastWalkDesignTest {

    private static final FastWalkDesign DESIGN = new FastWalkDesign(4);
    private static final int STRAIGHT = 0;
    private static final int TURN = 1;

    @Test
    void prefersTheFastWalkToTheNumbersWithWhichItBegan() {
        double[] begun = Arrays.copyOf(WalkStyle.coordinates(), FastWalk.PARAMETERS);

        assertThat(DESIGN.cost(FastWalk.coordinates(), STRAIGHT)).isLessThan(DESIGN.cost(begun, STRAIGHT));
        assertThat(DESIGN.cost(FastWalk.coordinates(), TURN)).isLessThan(DESIGN.cost(begun, TURN));
    }

    @Test
    void goesTheSameWayEachTime() {
        assertThat(firstGeneration()).isEqualTo(firstGeneration());
    }

    private static List<Double> firstGeneration() {
        List<Double> costs = new ArrayList<>();
        new Search(new SearchPlan(3, 0.3, 4, 1, 2, 1), DESIGN)
                .run(FastWalk.coordinates(), progress -> costs.add(progress.meanCost()));
        return costs;
    }
}
