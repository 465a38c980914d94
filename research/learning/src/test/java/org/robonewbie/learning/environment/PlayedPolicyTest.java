package org.robonewbie.learning.environment;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Path;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Random;
import java.util.function.Supplier;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.robonewbie.agent.Agent;
import org.robonewbie.agent.PolicyPlayer;
import org.robonewbie.agent.policy.MotionGuide;
import org.robonewbie.agent.policy.Network;
import org.robonewbie.agent.policy.Policy;
import org.robonewbie.agent.policy.Quantity;
import org.robonewbie.agent.policy.file.PolicyFile;
import org.robonewbie.agent.walk.PolicyWalk;
import org.robonewbie.agent.walk.Stance;
import org.robonewbie.agent.walk.WalkReflex;
import org.robonewbie.agent.walk.WalkVelocity;
import org.robonewbie.learning.policy.PolicyModel;
import org.robonewbie.nao.Cycle;
import org.robonewbie.nao.Joint;
import org.robonewbie.nao.motion.Keyframe;
import org.robonewbie.nao.motion.Motion;
import org.robonewbie.nao.motion.Posture;
import org.robonewbie.trial.Controller;
import org.robonewbie.trial.RandomSource;
import org.robonewbie.trial.Scene;
import org.robonewbie.trial.Trial;
import org.robonewbie.trial.WorldState;

/** A policy does in an agent what it has done in its task. */
class PlayedPolicyTest {

    private static final int CYCLES = 15;
    private static final int CYCLES_OF_WALK = 30;

    @Test
    void agentMovesAsTheLearnerDid() {
        movesAsTheLearnerDid(Still::new, CYCLES, 1, 0.5);
    }

    @Test
    void actionsLastAsLongAsTheLearnersDid() {
        movesAsTheLearnerDid(Still::new, CYCLES, 3, 0.5);
    }

    @Test
    void agentCorrectsTheMotionAsTheLearnerDid() {
        movesAsTheLearnerDid(Nodding::new, CYCLES, 1, 20);
    }

    @Test
    void agentObservesItsGaitAsTheLearnerDid() {
        movesAsTheLearnerDid(Balancing::new, 9, 3, 1.5);
    }

    /** The engine of an agent begins to feel in its second cycle, so the angles differ a little. */
    @Test
    void agentCorrectsTheWalkAsTheLearnerDid() {
        Policy policy = policyOfMarching();
        Posture wanted = learnedToMarch(policy);

        assertThat(marched(Controller.ofAgent(new Walker(new PolicyWalk(policy), Marching.VELOCITY)))
                        .largestDifference(wanted))
                .isLessThan(0.5);
        assertThat(wanted.largestDifference(Stance.POSTURE)).isGreaterThan(10);
    }

    @Test
    void agentKeepsOnItsFeetByThePolicyOfPpoWhereTheEngineAloneFalls() throws IOException {
        Policy learned = PolicyFile.read(Path.of("../python/baselines/EngineRun-3.policy"));
        WalkVelocity fast = new WalkVelocity(0.9, 0, 0);

        assertThat(secondsOnItsFeet(new PolicyWalk(learned), fast)).isGreaterThan(4);
        assertThat(secondsOnItsFeet(new PolicyWalk(new PolicyWalk(learned).style(), WalkReflex.NONE), fast))
                .isLessThan(2.5);
    }

    private static double secondsOnItsFeet(PolicyWalk manner, WalkVelocity velocity) {
        try (Trial trial = Trial.direct(
                new Marching().scene(new RandomSource(1)), 1, Controller.ofAgent(new Walker(manner, velocity)))) {
            int cycles = 0;
            while (cycles < 250 && !trial.now().robot().isFallen()) {
                trial.step();
                cycles++;
            }
            return cycles * Cycle.SECONDS;
        }
    }

    private static Policy policyOfMarching() {
        double[] numbers =
                new Random(5).doubles(Network.size(19, 12), -0.05, 0.05).toArray();
        return new PolicyModel(
                        new EnvironmentSpec(Marching.class.getName(), List.of()),
                        ".*",
                        0,
                        PlayedPolicyTest.class.getClassLoader())
                .policy(List.of(), numbers);
    }

    private static Posture learnedToMarch(Policy policy) {
        try (TrainingEnvironment learned =
                new TrainingEnvironment(() -> List.of(runner(new Marching())), DomainRandomization.NONE)) {
            learned.reset(1);
            for (int i = 0; i < CYCLES_OF_WALK; i++) {
                learned.step(policy.network().apply(learned.observation()));
            }
            return learned.now().robot().joints();
        }
    }

    private static Posture marched(Controller walker) {
        try (Trial trial = Trial.direct(new Marching().scene(new RandomSource(1)), 1, walker)) {
            for (int i = 0; i < CYCLES_OF_WALK; i++) {
                trial.step();
            }
            return trial.now().robot().joints();
        }
    }

    @ParameterizedTest
    @ValueSource(doubles = {0.6, 1, 1.8})
    void agentGetsUpByTheShippedPolicyOnAnyGround(double grip) {
        Scene lying = GetUpTraining.lying(posture -> posture);
        try (Trial trial = Trial.direct(lying, 1, Controller.ofAgent(new Player(PolicyFile.shipped("get-up"))))) {
            trial.setGrip(grip);
            for (int i = 0; i < 200; i++) {
                trial.step();
            }

            assertThat(trial.now().robot().tiltDegrees()).isLessThan(15);
            assertThat(trial.now().robot().position().z()).isGreaterThan(0.3);
        }
    }

    private static void movesAsTheLearnerDid(
            Supplier<TrainingTask> tasks, int cycles, int cyclesPerAction, double leastDegrees) {
        DomainRandomization options = DomainRandomization.NONE.with("cycles", String.valueOf(cyclesPerAction));
        try (TrainingEnvironment learned = new TrainingEnvironment(() -> List.of(runner(tasks.get())), options)) {
            Policy policy = policy(learned, cyclesPerAction);
            learned.reset(1);
            Posture first = learned.now().robot().joints();
            for (int i = 0; i < cycles / cyclesPerAction; i++) {
                learned.step(policy.network().apply(learned.observation()));
            }
            Posture wanted = learned.now().robot().joints();

            assertThat(played(tasks.get(), policy, cycles).largestDifference(wanted))
                    .isLessThan(0.1);
            assertThat(wanted.largestDifference(first)).isGreaterThan(leastDegrees);
        }
    }

    private static Posture played(TrainingTask task, Policy policy, int cycles) {
        try (Trial trial = Trial.direct(task.scene(new RandomSource(1)), 1, Controller.ofAgent(new Player(policy)))) {
            for (int i = 0; i < cycles; i++) {
                trial.step();
            }
            return trial.now().robot().joints();
        }
    }

    /** Takes all that is observed, with weights that move the legs by some degrees. */
    private static Policy policy(TrainingEnvironment learned, int cyclesPerAction) {
        TrainingTask task = learned.task();
        List<ObservedQuantity> felt = learned.quantities();
        int[] sizes = {felt.size(), task.joints().size()};
        double weight = task.observesGait() ? 0.1 : 0.0003;
        double[] numbers =
                new Random(5).doubles(Network.size(sizes), -weight, weight).toArray();
        Map<String, List<Double>> others =
                new HashMap<>(Map.of("cycles-per-action", List.of((double) cyclesPerAction)));
        task.motion().ifPresent(motion -> others.put("motion", MotionGuide.numbers(motion)));
        return new Policy(
                "still",
                List.of(),
                others,
                felt.stream().map(one -> new Quantity(one.name(), one.unit())).toList(),
                task.outputs(),
                Network.of(sizes, numbers));
    }

    private static EpisodeRunner runner(TrainingTask task) {
        return new EpisodeRunner(task, task);
    }

    private static final class Player extends Agent {

        private final PolicyPlayer player;

        private Player(Policy policy) {
            player = new PolicyPlayer(policy);
        }

        @Override
        protected void think() {
            player.act(nao);
        }
    }

    private static final class Walker extends Agent {

        private final PolicyWalk manner;
        private final WalkVelocity velocity;

        private Walker(PolicyWalk manner, WalkVelocity velocity) {
            this.manner = manner;
            this.velocity = velocity;
        }

        @Override
        protected void think() {
            walk.setPolicy(manner);
            walk.towards(velocity.forward(), velocity.left(), velocity.turn());
        }
    }

    /** Walks ahead and to the left. */
    public static final class Marching extends Still {

        private static final WalkVelocity VELOCITY = new WalkVelocity(0.4, 0, 10);

        @Override
        public Optional<Policy> walk() {
            return Optional.of(WalkGuide.engine(200, new WalkVelocity(0.8, 0.2, 90), 0.3));
        }

        @Override
        protected WalkVelocity velocity() {
            return VELOCITY;
        }
    }

    /** Stands in the stance while it raises an arm and bends its head. */
    private static final class Nodding extends Still {

        private static final Posture UP = Stance.POSTURE.with(Joint.LEFT_SHOULDER_PITCH, -20);

        @Override
        public Optional<Motion> motion() {
            return Optional.of(new Motion(
                    "nod", List.of(new Keyframe(500, UP), new Keyframe(200, UP.with(Joint.NECK_PITCH, -20)))));
        }
    }

    /** Stands in the stance, and corrects it by what it observes of its gait. */
    private static final class Balancing extends Still {

        @Override
        public boolean observesGait() {
            return true;
        }

        @Override
        public double rangeDegrees(Joint joint) {
            return joint.name().endsWith("KNEE_PITCH") ? 20 : 10;
        }
    }

    /** Stands in the stance. */
    private static class Still extends TrainingTask {

        @Override
        public double rangeDegrees() {
            return 10;
        }

        @Override
        protected void see(WorldState first, WorldState now) {}

        @Override
        public double value() {
            return 0;
        }
    }
}
