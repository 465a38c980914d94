package org.robonewbie.learning.policy;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
import org.robonewbie.agent.Agent;
import org.robonewbie.agent.policy.file.PolicyFile;
import org.robonewbie.agent.walk.PolicyWalk;
import org.robonewbie.agent.walk.WalkStyle;
import org.robonewbie.simulator.soccer.SoccerParameters;
import org.robonewbie.trial.Performer;
import org.robonewbie.trial.RobotStart;
import org.robonewbie.trial.Scene;
import org.robonewbie.trial.Trial;
import org.robonewbie.trial.measure.Distance;

/** The shipped walk in an agent, on a whole simulator. */
class LearnedWalkTest {

    private static final Scene SCENE = Scene.of(RobotStart.at(-10, 3).after("stand"))
            .withParameters(SoccerParameters.league())
            .withBall(0, -9);

    @Test
    void agentWalksFasterThanTheEngineFromItsMessagesAlone() {
        Distance way = new Distance();

        try (Trial trial = Trial.served(SCENE, 5, Performer.ofAgent(new Walker()))) {
            trial.run(8, way);
        }

        assertThat(way.hasFallen()).isFalse();
        assertThat(way.value()).isGreaterThan(7 * WalkStyle.STANDARD.most().forward());
    }

    private static final class Walker extends Agent {

        private final PolicyWalk learned = new PolicyWalk(PolicyFile.shipped("walk"));

        @Override
        protected void think() {
            walk.setPolicy(learned);
            walk.towards(0.8, 0, 0);
        }
    }
}
