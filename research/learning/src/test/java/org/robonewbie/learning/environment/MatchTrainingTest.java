package org.robonewbie.learning.environment;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.robonewbie.agent.walk.SoccerPolicy;
import org.robonewbie.nao.Vector3;
import org.robonewbie.trial.Controller;
import org.robonewbie.trial.RandomSource;
import org.robonewbie.trial.Scene;
import org.robonewbie.trial.Trial;

class MatchTrainingTest {

    private static final double[] FORWARD = {1, 0, 0};
    private static final double[] STILL = {0, 0, 0};

    private static TrainingEnvironment match(String... options) {
        return new EnvironmentSpec("Match1v1", List.of(options)).create(MatchTrainingTest.class.getClassLoader());
    }

    @Test
    void positionsAreDirectionsThatGrowWithTheDistance() {
        double[] values = SoccerPolicy.values(true, List.of(new Vector3(0, -0.5, 0), new Vector3(4.5, 0, 0)));

        assertThat(values).containsExactly(new double[] {1, 0, -0.5, 0.9, 0}, within(1e-9));
        assertThat(SoccerPolicy.inputs(0, 1)).hasSize(9);
    }

    @Test
    void robotWalksAtTheVelocityThatAnActionTellsAndIsPaidForGettingToTheBall() {
        try (TrainingEnvironment match = match("x=-2", "y=0", "heading=0")) {
            match.reset(3);
            double earned = 0;
            for (int i = 0; i < 15; i++) {
                match.act(FORWARD, STILL);
                earned += match.reward();
            }

            assertThat(match.cycles()).isEqualTo(150);
            assertThat(earned).isBetween(0.8, 2.5);
            assertThat(match.reward(1)).isCloseTo(0, within(0.01));
        }
    }

    @Test
    void fallenRobotGetsUpByItself() {
        Scene lying = new GetUpTraining().scene(new RandomSource(1));
        try (Trial trial = Trial.direct(lying, 1, Controller.ofAgent(new SteeredAgent()))) {
            assertThat(trial.now().robot().isFallen()).isTrue();

            trial.run(12);

            assertThat(trial.now().robot().isStanding()).isTrue();
        }
    }

    @Test
    void equalSeedsGiveEqualMatchesForEveryRobot() {
        try (TrainingEnvironment match = match()) {
            match.reset(7);
            match.act(FORWARD, FORWARD);
            double[] left = match.observation(0);
            double[] right = match.observation(1);
            match.reset(8, Optional.empty());
            match.act(FORWARD, FORWARD);
            double[] other = match.observation(1);
            match.reset(7);
            match.act(FORWARD, FORWARD);

            assertThat(match.observation(0)).containsExactly(left);
            assertThat(match.observation(1)).containsExactly(right).isNotEqualTo(other);
        }
    }

    @Test
    void actionsAreNoJointSpeeds() {
        assertThatThrownBy(() -> match("speeds=1")).hasMessageContaining("Omit the option speeds.");
    }
}
