package org.robonewbie.workshop.team;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Map;
import org.junit.jupiter.api.Test;
import org.robonewbie.examples.Agent_Dummy;
import org.robonewbie.examples.Agent_LearnedSoccer;
import org.robonewbie.learning.series.MatchExperiment;

class LearnedSoccerTest {

    @Test
    void shippedPolicyWinsAMatch() throws Exception {
        Map<String, String> agents =
                Map.of("agent", Agent_LearnedSoccer.class.getName(), "opponent", Agent_Dummy.class.getName());

        double[] result = new MatchExperiment().run(Map.of(), agents, 8922234730643124579L);

        assertThat(result).startsWith(1, 0);
    }
}
