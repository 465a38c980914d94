package org.robonewbie.trial;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.HashSet;
import java.util.Set;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.robonewbie.agent.Agent;
import org.robonewbie.nao.model.RobotType;

class RobotTypeTest {

    @ParameterizedTest
    @EnumSource
    void agentKnowsHowItIsBuilt(RobotType type) {
        Curious agent = new Curious();

        try (Trial trial = Trial.served(Scene.of(RobotStart.at(0, 0).withType(type)), 1, Controller.ofAgent(agent))) {
            trial.run(0.1);
        }

        assertThat(agent.types).containsExactly(type);
    }

    /** Notes the type that it is told. */
    private static final class Curious extends Agent {

        private final Set<RobotType> types = new HashSet<>();

        @Override
        protected void think() {
            types.add(nao.getType());
        }
    }
}
