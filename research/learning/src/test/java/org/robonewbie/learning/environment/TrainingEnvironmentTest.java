package org.robonewbie.learning.environment;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Random;
import java.util.function.Supplier;
import java.util.stream.IntStream;
import java.util.stream.LongStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.robonewbie.nao.Joint;
import org.robonewbie.nao.Vector3;
import org.robonewbie.trial.Measure;
import org.robonewbie.trial.RandomSource;
import org.robonewbie.trial.RobotStart;
import org.robonewbie.trial.Scene;
import org.robonewbie.trial.WorldState;
import org.robonewbie.trial.measure.Distance;

class TrainingEnvironmentTest {

    private static final double[] NOTHING = new double[12];

    @ParameterizedTest
    @ValueSource(
            strings = {
                "Stand",
                "Walk",
                "Follow",
                "EngineFollow",
                "Run",
                "EngineRun",
                "WalkGait",
                "JogGait",
                "RunGait",
                "GetUp",
                "QuickGetUp",
                "Kick",
                "KickTo",
                "Reach"
            })
    void equalSeedsGiveEqualEpisodesAndOthersOthers(String task) {
        TrainingEnvironment used = environment(task);
        track(used, 3);

        assertThat(track(used, 7)).isEqualTo(track(environment(task), 7));
        assertThat(track(used, 7)).isNotEqualTo(track(used, 8));
    }

    @Test
    void episodesInOtherThreadsDoNotDisturb() {
        List<List<Double>> alone = LongStream.range(0, 6)
                .mapToObj(seed -> track(environment("Kick"), seed))
                .toList();

        List<List<Double>> together = LongStream.range(0, 6)
                .parallel()
                .mapToObj(seed -> track(environment("Kick"), seed))
                .toList();

        assertThat(together).isEqualTo(alone);
    }

    @Test
    void observationHasANameForEachNumberAndIsPlausible() {
        TrainingEnvironment kick = environment("Kick");
        kick.step(NOTHING);

        double[] seen = kick.observation();

        assertThat(seen).hasSameSizeAs(kick.quantities());
        assertThat(kick.quantities()).extracting(ObservedQuantity::name).doesNotHaveDuplicates();
        assertThat(value(kick, seen, "accelerometer.up")).isCloseTo(9.81, within(1.0));
        assertThat(value(kick, seen, "leftFoot.force.up") + value(kick, seen, "rightFoot.force.up"))
                .isCloseTo(4.6 * 9.81, within(5.0));
        assertThat(value(kick, seen, "joint.LEFT_KNEE_PITCH")).isCloseTo(-70, within(1.0));
        assertThat(value(kick, seen, "ball.inSight")).isIn(0.0, 1.0);
        assertThat(seen)
                .isEqualTo(Arrays.stream(seen)
                        .map(number -> Math.rint(number * 100) / 100)
                        .toArray());
    }

    @Test
    void ballInTheCameraStaysUntilTheNextPicture() {
        TrainingEnvironment far =
                new TrainingEnvironment(() -> List.of(runner(new FarBall())), DomainRandomization.NONE);
        far.step(NOTHING);
        double[] first = far.observation();
        far.step(NOTHING);
        double[] second = far.observation();
        far.step(NOTHING);
        far.observation();
        far.step(NOTHING);
        double[] fourth = far.observation();

        int ball = first.length - 4;
        assertThat(value(far, first, "ball.inSight")).isEqualTo(1);
        assertThat(value(far, first, "ball.distance")).isCloseTo(1.1, within(0.1));
        assertThat(Arrays.copyOfRange(second, ball, ball + 4)).isEqualTo(Arrays.copyOfRange(first, ball, ball + 4));
        assertThat(Arrays.copyOfRange(fourth, ball, ball + 4)).isNotEqualTo(Arrays.copyOfRange(first, ball, ball + 4));
    }

    @Test
    void actionIsSeenTwoStepsLater() {
        TrainingEnvironment reach = environment("Reach");
        int shoulder = Joint.LEFT_SHOULDER_PITCH.ordinal();
        double before = reach.observation()[shoulder];

        reach.step(1, 0, 0, 0);
        double one = reach.observation()[shoulder];
        reach.step(1, 0, 0, 0);
        double two = reach.observation()[shoulder];

        assertThat(one).isCloseTo(before, within(0.02));
        assertThat(two).isGreaterThan(before + 1);
    }

    @Test
    void robotWalksNowhereWithoutLearning() {
        Random random = new Random(1);

        assertThat(meanMetres(() -> NOTHING)).isBetween(-0.1, 0.1);
        assertThat(meanMetres(() -> random.doubles(12, -1, 1).toArray())).isBetween(-0.3, 0.3);
    }

    /** Returns how far ahead the robot gets in an episode of the task Walk. */
    private static double meanMetres(Supplier<double[]> actions) {
        TrainingEnvironment walk = environment("Walk");
        return LongStream.range(0, 16)
                .mapToDouble(seed -> {
                    walk.reset(seed);
                    double start = walk.now().place().x();
                    while (!walk.isTerminated() && !walk.isTruncated()) {
                        walk.step(actions.get());
                    }
                    return walk.now().place().x() - start;
                })
                .average()
                .orElseThrow();
    }

    @Test
    void walkTellsHowFarToTurnWithAnErrorThatChangesEachSecond() {
        TrainingEnvironment walk = environment("Walk");
        int heading = walk.quantities().size() - 1;
        List<Double> degrees = new Random(1)
                .longs(20)
                .mapToObj(seed -> {
                    walk.reset(seed);
                    return 30 * walk.observation()[heading];
                })
                .toList();

        assertThat(walk.quantities().get(heading).name()).isEqualTo("command.heading");
        assertThat(degrees)
                .allMatch(angle -> Math.abs(angle) <= 38.1)
                .anyMatch(angle -> angle > 3)
                .anyMatch(angle -> angle < -3);
        double first = 30 * walk.observation()[heading];
        double[] after = new double[2];
        for (int second = 0; second < 2; second++) {
            for (int action = 0; action < (second == 0 ? 20 : 25); action++) {
                walk.step(NOTHING);
            }
            after[second] = 30 * walk.observation()[heading];
        }
        assertThat(after[0]).isCloseTo(first, within(0.5));
        assertThat(Math.abs(after[1] - first)).isBetween(0.5, 16.5);
    }

    @Test
    void anActionOfWalkLastsTwoCyclesUnlessAnOptionSetsThem() {
        TrainingEnvironment walk = environment("Walk");
        TrainingEnvironment fine = environment("Walk", "cycles=1");

        walk.step(NOTHING);
        fine.step(NOTHING);

        assertThat(walk.cycles()).isEqualTo(2);
        assertThat(fine.cycles()).isEqualTo(1);
    }

    @Test
    void rewardsAddUpToTheValueOfTheMeasure() {
        TrainingEnvironment walk = environment("Walk", "reward=distance-walked", "cycles=1");
        walk.reset(1);
        double sum = 0;
        double[] bend = NOTHING.clone();
        bend[legs().indexOf(Joint.LEFT_FOOT_PITCH)] = 1;
        bend[legs().indexOf(Joint.RIGHT_FOOT_PITCH)] = 1;
        Measure distance = new Distance();
        distance.see(walk.now());

        for (int i = 0; i < 60; i++) {
            walk.step(bend);
            distance.see(walk.now());
            sum += walk.reward();
        }

        assertThat(distance.value()).isNotZero();
        assertThat(sum).isCloseTo(distance.value(), within(1e-12));
    }

    @Test
    void measureOfWhichLessIsBetterCosts() {
        TrainingEnvironment energy = environment("Stand", "reward=energy");

        energy.step(0.5, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0);
        energy.step(0.5, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0);
        energy.step(0.5, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0);

        assertThat(energy.reward()).isNegative();
    }

    @Test
    void robotThatFallsEndsItsEpisode() {
        TrainingEnvironment stand = environment("Stand");
        double[] bend = NOTHING.clone();
        Arrays.fill(bend, 1);

        for (int i = 0; i < 150 && !stand.isTerminated(); i++) {
            stand.step(bend);
        }

        assertThat(stand.isTerminated()).isTrue();
        stand.reset(1);
        assertThat(stand.isTerminated()).isFalse();
        assertThat(stand.reward()).isZero();
    }

    @Test
    void taskOfYourOwnMayChangeTheSceneFromEpisodeToEpisode() {
        TrainingEnvironment wandering = environment(Wandering.class.getName());

        wandering.reset(2);
        double second = wandering.now().place().x();
        wandering.reset(1);

        assertThat(second).isCloseTo(-2, within(0.05));
        assertThat(wandering.now().place().x()).isCloseTo(-1, within(0.05));
    }

    @Test
    void commandIsObservedAndErrorsOfTheVelocityCost() {
        TrainingEnvironment still = following("0");
        TrainingEnvironment slow = following("0.15");

        double atRest = IntStream.range(0, 100).mapToDouble(i -> reward(still)).sum();
        double tooSlow = IntStream.range(0, 100).mapToDouble(i -> reward(slow)).sum();

        assertThat(value(slow, slow.observation(), "command.forward")).isEqualTo(0.15);
        assertThat(atRest).isCloseTo(80 * 0.02, within(0.1));
        assertThat(atRest - tooSlow).isCloseTo(80 * 0.02 * 0.15 / 0.3, within(0.1));
    }

    @Test
    void standingStillFollowsACommandToStandOnly() {
        TrainingEnvironment still = following("0");
        TrainingEnvironment lazy = following("0.5");
        boolean atOnce = still.task().isDone();

        IntStream.range(0, 100).forEach(i -> still.step(NOTHING));
        IntStream.range(0, 100).forEach(i -> lazy.step(NOTHING));

        assertThat(atOnce).isFalse();
        assertThat(still.task().isDone()).isTrue();
        assertThat(lazy.task().isDone()).isFalse();
        assertThat(lazy.task().hasFallen()).isFalse();
    }

    @Test
    void robotThatCorrectsNothingWalksByTheEngineAndIsPaidForTheWay() {
        TrainingEnvironment run = environment("EngineRun");
        run.reset(1);
        double before = run.now().place().x();

        double paid = IntStream.range(0, 60).mapToDouble(i -> reward(run)).sum();

        assertThat(run.task().hasFallen()).isFalse();
        assertThat(paid).isGreaterThan(0.2).isCloseTo(run.now().place().x() - before, within(0.02));
        assertThat(value(run, run.observation(), "wanted.forward")).isBetween(0.7, 1.1);
        assertThat(run.observation()).hasSize(19);
    }

    @Test
    void correctedWalkIsPaidForTheWayThatItIsTold() {
        TrainingEnvironment away = walking("180");
        TrainingEnvironment ahead = walking("0");

        IntStream.range(0, 60).forEach(i -> {
            away.step(NOTHING);
            ahead.step(NOTHING);
        });

        assertThat(ahead.task().value()).isGreaterThan(0.2);
        assertThat(away.task().value()).isLessThan(ahead.task().value() / 2);
    }

    @Test
    void secondsWithoutAFootOnTheGroundCostWhatTheOptionSays() {
        double free = returnOf(environment("RunGait", "forward=1.2"));

        double cyclesInTheAir = (free - returnOf(environment("RunGait", "forward=1.2", "flight=10"))) / (10 * 0.02);

        assertThat(cyclesInTheAir).isBetween(1.0, 59.0).isCloseTo(Math.rint(cyclesInTheAir), within(1e-6));
    }

    private static double returnOf(TrainingEnvironment environment) {
        environment.reset(1);
        return IntStream.range(0, 60).mapToDouble(i -> reward(environment)).sum();
    }

    private static TrainingEnvironment walking(String degreesPerSecond) {
        TrainingEnvironment walk = environment("EngineFollow", "forward=0.5", "turn=" + degreesPerSecond);
        walk.reset(1);
        return walk;
    }

    @Test
    void walkIsCorrectedCycleByCycle() {
        assertThatThrownBy(() -> environment("EngineRun", "cycles=2"))
                .hasMessage("An action of this task corrects a single cycle of a walk. Omit the option \"cycles\".");
    }

    private static TrainingEnvironment following(String metresPerSecond) {
        TrainingEnvironment follow = environment("Follow", "forward=" + metresPerSecond);
        follow.reset(1);
        return follow;
    }

    private static double reward(TrainingEnvironment environment) {
        environment.step(NOTHING);
        return environment.reward();
    }

    @Test
    void commandChangesEachThreeSeconds() {
        TrainingEnvironment follow = environment("Follow");
        follow.reset(2);
        double first = value(follow, follow.observation(), "command.forward");

        IntStream.range(0, 149).forEach(i -> follow.step(NOTHING));
        double same = value(follow, follow.observation(), "command.forward");
        follow.step(NOTHING);

        assertThat(same).isEqualTo(first);
        assertThat(value(follow, follow.observation(), "command.forward")).isNotEqualTo(first);
    }

    @Test
    void robotThatIsToGetUpLiesOnItsFrontAndIsPaidForStandingOnly() {
        TrainingEnvironment getUp = environment("GetUp");
        getUp.reset(3);

        IntStream.range(0, 50).forEach(i -> getUp.step(new double[20]));

        assertThat(getUp.now().robot().isFallen()).isTrue();
        assertThat(getUp.now()
                        .robot()
                        .torso()
                        .rotation()
                        .apply(new Vector3(1, 0, 0))
                        .z())
                .isLessThan(-0.7);
        assertThat(getUp.task().isDone()).isFalse();
        assertThat(getUp.isTerminated()).isFalse();
        assertThat(getUp.task().value()).isBetween(0.0, 0.2);
    }

    private static List<Joint> legs() {
        return new FarBall().joints();
    }

    private static TrainingEnvironment environment(String task, String... options) {
        return new EnvironmentSpec(task, List.of(options)).create(TrainingEnvironmentTest.class.getClassLoader());
    }

    private static double value(TrainingEnvironment environment, double[] seen, String name) {
        return seen[
                environment.quantities().stream()
                        .map(ObservedQuantity::name)
                        .toList()
                        .indexOf(name)];
    }

    /** What a robot with random actions perceives and earns. */
    private static List<Double> track(TrainingEnvironment environment, long seed) {
        environment.reset(seed);
        Random random = new Random(0);
        List<Double> track = new ArrayList<>();
        for (int i = 0; i < 60; i++) {
            environment.step(random.doubles(environment.task().joints().size(), -0.5, 0.5)
                    .toArray());
            Arrays.stream(environment.observation()).forEach(track::add);
            track.add(environment.reward());
        }
        return track;
    }

    private static EpisodeRunner runner(TrainingTask task) {
        return new EpisodeRunner(task, task);
    }

    /** The robot looks at a ball 1 m ahead. */
    public static class FarBall extends TrainingTask {

        /** Creates the task. */
        public FarBall() {}

        @Override
        public double rangeDegrees() {
            return 10;
        }

        @Override
        public boolean hasCamera() {
            return true;
        }

        @Override
        protected void see(WorldState first, WorldState now) {}

        @Override
        public double value() {
            return 0;
        }
    }

    /** Each episode begins somewhere else. */
    public static final class Wandering extends FarBall {

        /** Creates the task. */
        public Wandering() {}

        @Override
        public Scene scene(RandomSource random) {
            return Scene.of(RobotStart.at(-(double) random.seed(), 0));
        }
    }
}
