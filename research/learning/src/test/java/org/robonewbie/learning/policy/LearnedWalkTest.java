package org.robonewbie.learning.policy;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.robonewbie.agent.Agent;
import org.robonewbie.agent.policy.file.PolicyFile;
import org.robonewbie.agent.walk.PolicyWalk;
import org.robonewbie.simulator.soccer.SoccerParameters;
import org.robonewbie.trial.Controller;
import org.robonewbie.trial.RobotStart;
import org.robonewbie.trial.Scene;
import org.robonewbie.trial.Trial;
import org.robonewbie.trial.measure.Distance;

/** The shipped walk in an agent, on a whole simulator. */
class LearnedWalkTest {

    private static final Scene SCENE = Scene.of(RobotStart.at(-10, 3).after("stand"))
            .withParameters(SoccerParameters.league())
            .withBall(0, -9);

    @ParameterizedTest
    @CsvSource({"walk, 0.7", "jog, 0.9", "run, 1.1"})
    void agentGetsAheadFromItsMessagesAlone(String policy, double metresPerSecond) {
        Distance way = new Distance();

        try (Trial trial = Trial.served(SCENE, 5, Controller.ofAgent(new Walker(policy)))) {
            trial.run(8, way);
        }

        assertThat(way.hasFallen()).isFalse();
        assertThat(way.value()).isGreaterThan(8 * metresPerSecond);
    }

    private static final class Walker extends Agent {

        private final PolicyWalk learned;

        private Walker(String policy) {
            learned = new PolicyWalk(PolicyFile.shipped(policy));
        }

        @Override
        protected void think() {
            walk.setPolicy(learned);
            walk.towards(learned.style().most().forward(), 0, 0);
        }
    }
}
