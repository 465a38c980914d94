package org.robonewbie.learning.policy;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Arrays;
import java.util.List;
import org.junit.jupiter.api.Test;

class EvolutionStrategyTest {

    private final EvolutionStrategy strategy = new EvolutionStrategy(4, 10, 0.1, 0.05);

    @Test
    void climbsAHillOfTwentyNumbers() {
        double[] start = new double[20];
        Arrays.fill(start, 1);

        EvolutionStrategy.State state = climb(start, 200);

        assertThat(height(state.mean())).isGreaterThan(-0.2);
        assertThat(state.generation()).isEqualTo(200);
    }

    @Test
    void drawsTheSameCandidatesAgain() {
        EvolutionStrategy.State state = climb(new double[5], 3);

        List<double[]> candidates = strategy.ask(state);

        assertThat(candidates).hasSize(20).containsExactlyElementsOf(strategy.ask(state));
        assertThat(candidates.get(0))
                .isNotEqualTo(strategy.ask(climb(new double[5], 4)).get(0));
    }

    @Test
    void bothOfAPairLieOppositeAndGetTheSameTrial() {
        EvolutionStrategy.State state = EvolutionStrategy.State.begin(new double[] {2}, new double[] {3});

        List<double[]> candidates = strategy.ask(state);

        assertThat(candidates.get(0)[0] + candidates.get(1)[0]).isEqualTo(4);
        assertThat(strategy.seedOfTrial(state, 0)).isEqualTo(strategy.seedOfTrial(state, 1));
        assertThat(strategy.seedOfTrial(state, 2)).isNotEqualTo(strategy.seedOfTrial(state, 1));
    }

    private EvolutionStrategy.State climb(double[] start, int generations) {
        double[] units = new double[start.length];
        Arrays.fill(units, 1);
        EvolutionStrategy.State state = EvolutionStrategy.State.begin(start, units);
        for (int i = 0; i < generations; i++) {
            state = strategy.tell(
                    state,
                    strategy.ask(state).stream()
                            .mapToDouble(EvolutionStrategyTest::height)
                            .toArray());
        }
        return state;
    }

    private static double height(double... x) {
        return -Arrays.stream(x).map(v -> v * v).sum();
    }
}
