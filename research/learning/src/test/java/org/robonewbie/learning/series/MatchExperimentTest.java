package org.robonewbie.learning.series;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.Map;
import org.junit.jupiter.api.Test;
import org.robonewbie.agent.Agent;

class MatchExperimentTest {

    /** An agent that does nothing. */
    public static final class Idle extends Agent {}

    @Test
    void matchWithoutAGoalIsADraw() throws Exception {
        Map<String, String> agents = Map.of("agent", Idle.class.getName(), "opponent", Idle.class.getName());

        double[] result = new MatchExperiment().run(Map.of("seconds", 1.0), agents, 1);

        assertThat(result).hasSize(3).startsWith(0, 0);
        assertThat(result[2]).isGreaterThanOrEqualTo(1);
    }

    @Test
    void planWithoutAnAgentIsRefused() {
        assertThatThrownBy(() -> new MatchExperiment().run(Map.of(), 1))
                .hasMessageStartingWith("The plan names no agent");
    }

    @Test
    void unknownAgentIsNamed() {
        Map<String, String> agents = Map.of("agent", Idle.class.getName(), "opponent", "org.example.Agent_Dumy");

        assertThatThrownBy(() -> new MatchExperiment().run(Map.of(), agents, 1))
                .hasMessageStartingWith(
                        "There is no agent \"org.example.Agent_Dumy\". A class of your own must extend Agent");
    }
}
