package org.robonewbie.learning.policy;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.robonewbie.agent.policy.Policy;
import org.robonewbie.agent.policy.PolicyText;
import org.robonewbie.agent.policy.file.PolicyFile;
import org.robonewbie.agent.walk.PolicyWalk;
import org.robonewbie.learning.environment.EnvironmentSpec;
import org.robonewbie.learning.environment.TrainingTask;
import org.robonewbie.nao.Joint;
import org.robonewbie.trial.WorldState;

class PolicyModelTest {

    private static final ClassLoader CLASSES = PolicyModelTest.class.getClassLoader();
    private static final String NOISE = "noise=0.1";

    @TempDir
    private Path folder;

    @Test
    void initialPolicyDoesNothing() throws IOException {
        PolicyModel stand = model("Stand", NOISE);

        RolloutStatistics result = PolicySearch.evaluate(stand, 1, stand.policy(List.of(), stand.initial(3)));

        assertThat(result.falls()).isEqualTo(1);
        assertThat(result.seconds()).isGreaterThan(3);
    }

    @Tag("slow")
    @Test
    void learnsWhatPays() throws IOException {
        PolicyModel salute = model(Salute.class.getName(), NOISE);
        PolicySearch search = search(salute);
        Policy before = salute.policy(List.of(), salute.initial(1));

        Policy learned = search.run(40, Optional.empty(), line -> {});

        RolloutStatistics result = PolicySearch.evaluate(salute, 5, learned);
        assertThat(PolicySearch.evaluate(salute, 5, before).successes()).isZero();
        assertThat(result.successes()).isEqualTo(5);
        assertThat(result.toString()).startsWith("success 5 of 5, 0 falls, return ");
        assertThat(Files.readAllLines(search.curve()))
                .hasSize(41)
                .first()
                .isEqualTo("generation,episodes,cycles,reward,falls,speedError,turnError,successes");
    }

    @Test
    void takesItsOwnPolicyAsInitialNumbers() throws IOException {
        PolicyModel salute = model(Salute.class.getName(), NOISE);
        PolicySearch search = search(salute);
        Policy learned = search.run(1, Optional.empty(), line -> {});

        Policy again = salute.policy(learned.about(), salute.initial(PolicyFile.read(search.output())));

        assertThat(PolicyText.format(again)).isEqualTo(PolicyText.format(learned));
        assertThat(learned.about())
                .containsExactly("learned by: robonewbie learn " + Salute.class.getName()
                        + " --seed 1 --pairs 4 --sigma 0.02 --learning-rate 0.02 --option noise=0.1 --generations 1");
    }

    @Test
    void policyCarriesTheMotionThatItCorrects() {
        PolicyModel kick = model("KickTo");

        Policy policy = kick.policy(List.of(), kick.initial(1));

        assertThat(policy.numbers()).containsOnlyKeys("motion");
        assertThat(policy.inputs()).extracting("name").contains("motion.sine-1", "command.distance", "gyro.left");
    }

    @Test
    void policyCarriesTheGaitThatIsLearned() {
        PolicyModel walk = model("WalkGait");
        Policy shipped = PolicyFile.shipped("walk");

        Policy again = walk.policy(List.of(), walk.initial(shipped));

        assertThat(new PolicyWalk(again).style()).isEqualTo(new PolicyWalk(shipped).style());
        assertThat(again.network().numbers()).isEqualTo(shipped.network().numbers());
    }

    @Test
    void refusesPoliciesWithOtherLayers() {
        PolicyModel stand = model("Stand");
        PolicyModel narrow = model("Stand", PolicyModel.DEFAULT_INPUTS, 8);
        String text = PolicyText.format(stand.policy(List.of(), stand.initial(1)));

        assertThatThrownBy(() -> stand.initial(narrow.policy(List.of(), narrow.initial(1))))
                .hasMessageContaining(" 8 tanh, layer 8 ")
                .hasMessageContaining("Pass the same --hidden value");
        assertThatThrownBy(() -> stand.initial(PolicyText.parse(text.replaceFirst("tanh", "elu"))))
                .hasMessageContaining("16 elu, layer 16 ")
                .hasMessageContaining("other activation functions cannot be trained further here");
    }

    @Test
    void policyKeepsAnActionAsLongAsWhileItWasLearned() throws IOException {
        PolicyModel slow = model("Stand", "cycles=5");
        PolicyModel stand = model("Stand");
        EvolutionStrategy strategy = new EvolutionStrategy(1, 4, 0.5, 0.5);

        Policy learned =
                new PolicySearch(slow, strategy, folder.resolve("slow.policy")).run(1, Optional.empty(), line -> {});

        assertThat(learned.cyclesPerAction()).isEqualTo(5);
        assertThat(PolicySearch.evaluate(stand, 4, learned)).isEqualTo(PolicySearch.evaluate(slow, 4, learned));
    }

    @Test
    void seedChoosesTheEpisodesOfAnEvaluation() throws IOException {
        PolicyModel stand = model("Stand");
        Policy policy = stand.policy(List.of(), stand.initial(1));

        RolloutStatistics usual = PolicySearch.evaluate(stand, 4, policy);

        assertThat(PolicySearch.evaluate(stand, 4, 1, policy)).isEqualTo(usual);
        assertThat(PolicySearch.evaluate(stand, 4, 9001, policy)).isNotEqualTo(usual);
        assertThatThrownBy(() -> PolicySearch.evaluate(stand, 4, 0, policy))
                .hasMessage("The seed of an evaluation must be between 1 and 1000000000, not 0.");
    }

    @Test
    void refusesWhatCannotBeLearned() {
        assertThatThrownBy(() -> model("Match1v1"))
                .hasMessage("Match1v1 trains several robots; choose a task for a single robot.");
        assertThatThrownBy(() -> model("Stnd"))
                .hasMessageStartingWith("There is no task \"Stnd\". Did you mean Stand? Available: ");
        assertThatThrownBy(() -> model("Stand", "speed=1")).hasMessageStartingWith("This task has no option speed. ");
        assertThatThrownBy(() -> model("Stand", "wing.*", 16))
                .hasMessage("No observed quantity of Stand has a name that matches wing.*.");
        assertThatThrownBy(() -> model("Stand").initial(PolicyFile.shipped("walk")))
                .hasMessageContaining("Was the policy trained for another task?");
        assertThatThrownBy(() -> PolicySearch.evaluate(model("Stand"), 1, PolicyFile.shipped("walk")))
                .hasStackTraceContaining("step.sine-of-2-pi-phase in 1, which this task does not observe.");
    }

    @Test
    void shippedKickComesNearerToWhatIsWantedThanTheMotionAlone() throws IOException {
        PolicyModel kick = model("KickTo", "command.*", 0, NOISE);

        RolloutStatistics learned = PolicySearch.evaluate(kick, 20, PolicyFile.shipped("kick-to"));
        RolloutStatistics alone = PolicySearch.evaluate(kick, 20, kick.policy(List.of(), kick.initial(1)));

        assertThat(learned.falls()).isZero();
        assertThat(learned.meanReturn()).isGreaterThan(alone.meanReturn() + 0.15);
    }

    @Tag("slow")
    @Test
    void shippedStandBearsHarderPushesThanTheStanceAlone() throws IOException {
        PolicyModel stand = model("Stand", "gyro\\.(forward|left)", 0, NOISE);

        RolloutStatistics learned = PolicySearch.evaluate(stand, 40, PolicyFile.shipped("stand"));
        RolloutStatistics alone = PolicySearch.evaluate(stand, 40, stand.policy(List.of(), stand.initial(1)));

        assertThat(learned.seconds()).isGreaterThan(alone.seconds() + 40 * 0.2);
        assertThat(learned.successes()).isGreaterThan(alone.successes() + 8);
    }

    @Tag("slow")
    @Test
    void shippedGetUpStandsUpMoreOftenThanTheMotionAloneWhereFeetHoldLessOrMore() throws IOException {
        PolicyModel getUp = model(
                "QuickGetUp", "motion.*|gyro.left|accelerometer.(forward|up)", 0, "friction=0.5..2", "mass=0.9..1.1");

        RolloutStatistics learned = PolicySearch.evaluate(getUp, 40, PolicyFile.shipped("get-up"));
        RolloutStatistics alone = PolicySearch.evaluate(getUp, 40, getUp.policy(List.of(), getUp.initial(1)));

        assertThat(learned.successes()).isGreaterThan(alone.successes() + 8);
        assertThat(learned.meanReturn()).isGreaterThan(alone.meanReturn() + 0.7);
    }

    @Test
    void searchStartsFromTheShippedKick() throws IOException {
        PolicyModel kick = model("KickTo", "command.*", 0, NOISE);
        Policy shipped = PolicyFile.shipped("kick-to");

        Policy next = search(kick).run(1, Optional.of(shipped), line -> {});

        assertThat(next.network().numbers()).hasSameSizeAs(shipped.network().numbers());
        assertThat(next.network().numbers()).isNotEqualTo(shipped.network().numbers());
        assertThat(next.about()).hasSize(shipped.about().size() + 1);
    }

    private PolicySearch search(PolicyModel model) {
        return new PolicySearch(model, new EvolutionStrategy(1, 4, 0.02, 0.02), folder.resolve("task.policy"));
    }

    private static PolicyModel model(String task, String... options) {
        return model(task, PolicyModel.DEFAULT_INPUTS, PolicyModel.DEFAULT_HIDDEN, options);
    }

    private static PolicyModel model(String task, String inputs, int hidden, String... options) {
        return new PolicyModel(new EnvironmentSpec(task, List.of(options)), inputs, hidden, CLASSES);
    }

    /** Raises the left arm by some degrees and holds it there. */
    public static final class Salute extends TrainingTask {

        private static final double WAY = 20;

        private double away;

        /** Creates the task. */
        public Salute() {}

        @Override
        public List<Joint> joints() {
            return List.of(Joint.LEFT_SHOULDER_PITCH);
        }

        @Override
        public double rangeDegrees() {
            return 30;
        }

        @Override
        public int longestCycles() {
            return 20;
        }

        @Override
        protected void see(WorldState first, WorldState now) {
            double moved = now.robot().joints().degrees(Joint.LEFT_SHOULDER_PITCH)
                    - first.robot().joints().degrees(Joint.LEFT_SHOULDER_PITCH);
            away = Math.abs(moved - WAY);
        }

        @Override
        public boolean isDone() {
            return away < WAY / 2;
        }

        @Override
        public double value() {
            return -away;
        }
    }
}
