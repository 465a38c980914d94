package org.robonewbie.learning.gym;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.Map;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.robonewbie.agent.Agent;
import org.robonewbie.agent.policy.Network;
import org.robonewbie.agent.policy.Policy;
import org.robonewbie.agent.policy.PolicyPlayer;
import org.robonewbie.agent.policy.Quantity;
import org.robonewbie.nao.motion.Posture;
import org.robonewbie.trial.Chance;
import org.robonewbie.trial.Moment;
import org.robonewbie.trial.Performer;
import org.robonewbie.trial.Trial;

/** A policy does in an agent what it has done in its task. */
class PlayedPolicyTest {

    private static final int CYCLES = 15;

    /** An agent joins the game by its first answer, and moves from the second on. */
    private static final int CYCLES_OF_AN_AGENT = CYCLES + 1;

    private final GymEnvironment learned = new GymEnvironment(() -> List.of(new GymEpisode(new Still())));
    private final Policy policy = policy();

    @Test
    void agentMovesAsTheLearnerDid() {
        learned.reset(1);
        for (int i = 0; i < CYCLES; i++) {
            learned.step(policy.network().apply(learned.observation()));
        }
        Posture wanted = learned.now().robot().joints();

        Posture played = played();

        assertThat(played.largestDifference(wanted)).isLessThan(0.1);
        assertThat(wanted.largestDifference(firstPosture())).isGreaterThan(0.5);
    }

    private Posture firstPosture() {
        learned.reset(1);
        return learned.now().robot().joints();
    }

    private Posture played() {
        try (Trial trial = Trial.direct(new Still().scene(new Chance(1)), 1, Performer.ofAgent(new Player()))) {
            for (int i = 0; i < CYCLES_OF_AN_AGENT; i++) {
                trial.step();
            }
            return trial.now().robot().joints();
        }
    }

    /** Takes what the robot feels, in units of its range, with weights that move the knees by some degrees. */
    private Policy policy() {
        List<ObservedQuantity> felt = learned.quantities();
        Random random = new Random(5);
        int[] sizes = {felt.size(), 12};
        double[] numbers = random.doubles(Network.size(sizes), -0.0004, 0.0004).toArray();
        return new Policy(
                "still",
                List.of(),
                Map.of("range-degrees", List.of(new Still().rangeDegrees())),
                felt.stream().map(one -> new Quantity(one.name(), one.unit())).toList(),
                new Still()
                        .joints().stream()
                                .map(joint -> new Quantity("joint." + joint, "10 degrees"))
                                .toList(),
                Network.of(sizes, numbers));
    }

    private final class Player extends Agent {

        private final PolicyPlayer player = new PolicyPlayer(policy);

        @Override
        protected void think() {
            player.act(nao);
        }
    }

    /** Stands in the stance. */
    private static final class Still extends GymTask {

        @Override
        public double rangeDegrees() {
            return 10;
        }

        @Override
        protected void see(Moment first, Moment now) {}

        @Override
        public double value() {
            return 0;
        }
    }
}
