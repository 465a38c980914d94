package org.robonewbie.trial;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.io.IOException;
import java.net.URL;
import java.net.URLClassLoader;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.robonewbie.nao.PlayMode;
import org.robonewbie.nao.Vector3;
import org.robonewbie.nao.kinematics.BodyState;
import org.robonewbie.nao.kinematics.Pose;
import org.robonewbie.nao.kinematics.Rotation;
import org.robonewbie.nao.model.RobotType;
import org.robonewbie.nao.motion.Posture;
import org.robonewbie.trial.measure.BalanceMetrics;
import org.robonewbie.trial.measure.BallToGoal;
import org.robonewbie.trial.measure.Energy;
import org.robonewbie.trial.measure.LongestKick;
import org.robonewbie.trial.measure.Measures;
import org.robonewbie.trial.measure.Pushes;
import org.robonewbie.trial.measure.Race;
import org.robonewbie.trial.measure.SustainedCondition;
import org.robonewbie.trial.measure.Turn;

class MeasuresTest {

    private static final Vector3 ASIDE = new Vector3(0, -3, 0.042);
    private static final double LYING = 90;

    @Test
    void distanceCountsAlongTheFirstHeadingOnly() {
        double metres = value("distance-walked", at(0, 0, 0, 0), at(1, 2, 0.5, 0));

        assertThat(metres).isCloseTo(2, within(1e-9));
    }

    @Test
    void distanceEndsWithTheFall() {
        double metres = value("distance-walked", at(0, 0, 0, 0), at(1, 1, 0, 0), at(2, 2, 0, LYING), at(3, 3, 0, 0));

        assertThat(metres).isCloseTo(1, within(1e-9));
    }

    @Test
    void speedIsSlowerForTheTimeOnTheGround() {
        double speed = value("walk-speed", at(0, 0, 0, 0), at(1, 1, 0, 0), at(4, 2, 0, LYING));

        assertThat(speed).isCloseTo(0.25, within(1e-9));
    }

    @Test
    void stabilityIsTheMeanTilt() {
        double degrees = value("stability", at(0, 0, 0, 0), at(1, 0, 0, 30));

        assertThat(degrees).isCloseTo(15, within(1e-6));
    }

    @Test
    void fallIsAsBadForStabilityAsLying() {
        double degrees = value("stability", at(0, 0, 0, LYING), at(1, 0, 0, 0));

        assertThat(degrees).isCloseTo(90, within(1e-6));
    }

    @Test
    void liftingTheRobotIsWorkAgainstItsWeight() {
        double joules = value("energy", lifted(0), lifted(0.001), lifted(0.002));

        double kilograms = 4.607;
        double speed = 0.001 / 0.02;
        double energy = kilograms * (9.81 * 0.002 + speed * speed / 2);
        assertThat(joules).isCloseTo(energy, within(0.01 * energy));
    }

    @Test
    void sinkingIsNoWork() {
        assertThat(value("energy", lifted(0.002), lifted(0.001), lifted(0)))
                .isLessThan(value("energy", lifted(0), lifted(0.001), lifted(0.002)) / 2);
        assertThat(new Energy().value()).isZero();
    }

    @Test
    void kickDistanceCountsWhatTheBallWillRollOn() {
        double metres = value(
                "kick-distance",
                ball(0, new Vector3(0.2, 0, 0.042), Vector3.ZERO, 0),
                ball(1, new Vector3(1.2, 0.1, 0.042), new Vector3(2, 0, 0), 0));

        assertThat(metres).isCloseTo(1 + 2 * 0.94, within(1e-9));
    }

    @Test
    void timeToScoreIsThatOfTheFirstGoal() {
        double seconds = value(
                "time-to-score",
                ball(0, ASIDE, Vector3.ZERO, 0),
                ball(7, ASIDE, Vector3.ZERO, 1),
                ball(9, ASIDE, Vector3.ZERO, 1));

        assertThat(seconds).isCloseTo(7, within(1e-9));
    }

    @Test
    void ballThatIsNearTheGoalIsBetterThanOneThatIsFar() {
        double near = value("time-to-score", ball(9, new Vector3(5, 0, 0.042), Vector3.ZERO, 0));
        double far = value("time-to-score", ball(9, ASIDE, Vector3.ZERO, 0));

        assertThat(near).isCloseTo(10, within(1e-9));
        assertThat(near).isLessThan(far);
    }

    @Test
    void getUpTimeCountsFromTheFirstMomentAndWaitsForASecondOnTheFeet() {
        double seconds = value("get-up-time", at(5, 0, 0, LYING), at(7, 0, 0, 0), at(7.5, 0, 0, 0), at(8.5, 0, 0, 0));

        assertThat(seconds).isCloseTo(3.5, within(1e-9));
    }

    @Test
    void turnCountsWholeTurns() {
        Turn turn = new Turn();

        for (int degrees = 0; degrees <= 400; degrees += 100) {
            turn.see(moment(0, pose(0, 0, 0.38, degrees, 0), ASIDE, Vector3.ZERO, 0));
        }

        assertThat(turn.value()).isCloseTo(400, within(1e-6));
    }

    @Test
    void namesAllMeasuresIfThereIsNoneOfAName() {
        assertThatThrownBy(() -> Measures.named("speed", getClass().getClassLoader()))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessageStartingWith(
                        "There is no measure \"speed\". Did you mean walk-speed? Available: distance-walked, energy,"
                                + " get-up-time, kick-distance, stability, standing-time, time-to-score, walk-speed.");
    }

    @Test
    void classThatAJarOffersIsKnownByItsSimpleName(@TempDir Path folder) throws IOException {
        Path services = Files.createDirectories(folder.resolve("META-INF/services"));
        Path offers = Files.writeString(services.resolve(Measure.class.getName()), Turn.class.getName() + "\n");

        try (URLClassLoader jar = new URLClassLoader(
                new URL[] {folder.toUri().toURL()}, getClass().getClassLoader())) {
            assertThat(Measures.named("Turn", jar).get()).isInstanceOf(Turn.class);
            assertThatThrownBy(() -> Measures.named("Turm", jar)).hasMessageContaining("There is no measure \"Turm\"");

            Files.writeString(offers, "no.such.Measure\n");
        }
        try (URLClassLoader wrong = new URLClassLoader(
                new URL[] {folder.toUri().toURL()}, getClass().getClassLoader())) {
            assertThatThrownBy(() -> Measures.named("Turn", wrong))
                    .hasMessageStartingWith("A jar or folder provides a Measure that cannot be loaded: ");
        }
    }

    @Test
    void anyClassCanBeAMeasure() {
        Measure measure = Measures.named(Turn.class.getName(), getClass().getClassLoader())
                .get();

        assertThat(measure).isInstanceOf(Turn.class);
    }

    @Test
    void raceCountsTheTimeAndWhatIsMissing() {
        Race race = new Race();

        List.of(at(2, 0, 0, 0), at(3, 1, 0, 0), at(4, 2, 0, LYING)).forEach(race::see);
        assertThat(race.value()).isCloseTo(2 + 10 * 2, within(1e-9));
        assertThat(race.isDecided()).isFalse();
        List.of(at(6, 4, 0, 0), at(9, 5, 0, 0)).forEach(race::see);

        assertThat(race.isDecided()).isTrue();
        assertThat(race.metres()).isEqualTo(3);
        assertThat(race.value()).isCloseTo(4, within(1e-9));
        assertThat(race.isLargerBetter()).isFalse();
        assertThat(race.unit()).isEqualTo("s");
    }

    @Test
    void longestKickCountsFromTheFoot() {
        LongestKick kick = new LongestKick();

        kick.see(ball(0, new Vector3(0.2, 0, 0.042), Vector3.ZERO, 0));
        kick.see(ball(1, new Vector3(0.3, 0, 0.042), Vector3.ZERO, 0));
        kick.see(ball(2, new Vector3(1.3, 0, 0.042), Vector3.ZERO, 0));
        kick.see(ball(3, new Vector3(0.8, 0, 0.042), Vector3.ZERO, 0));

        assertThat(kick.value()).isCloseTo(1, within(1e-9));
        assertThat(kick.isDecided()).isFalse();
        assertThat(kick.unit()).isEqualTo("m");
    }

    @Test
    void ballToGoalRemembersTheNearestPlace() {
        BallToGoal ball = new BallToGoal();

        ball.see(ball(1, new Vector3(5, 0, 0.042), Vector3.ZERO, 0));
        ball.see(ball(2, new Vector3(4, 0, 0.042), Vector3.ZERO, 0));
        assertThat(ball.value()).isCloseTo(1, within(1e-9));
        assertThat(ball.lastMetres()).isCloseTo(2, within(1e-9));
        ball.see(ball(3, ASIDE, Vector3.ZERO, 1));
        ball.see(ball(9, ASIDE, Vector3.ZERO, 1));

        assertThat(ball.isDecided()).isTrue();
        assertThat(ball.lastMetres()).isZero();
        assertThat(ball.seconds()).isEqualTo(3);
        assertThat(ball.isLargerBetter()).isFalse();
        assertThat(ball.unit()).isEqualTo("m");
    }

    @Test
    void balanceIsTheSpeedOfTilting() {
        BalanceMetrics balance = new BalanceMetrics();

        List.of(at(0, 0, 0, 0), at(0.02, 0, 0, 1), at(0.04, 0, 0, 1)).forEach(balance::see);

        assertThat(balance.value()).isCloseTo(25, within(0.01));
        assertThat(balance.meanJointsAtLimit()).isZero();
        assertThat(balance.isLargerBetter()).isFalse();
        assertThat(balance.unit()).isEqualTo("°/s");
    }

    @Test
    void conditionHasToLast() {
        SustainedCondition upright =
                new SustainedCondition(1, state -> state.robot().isStanding());

        List.of(at(1, 0, 0, 0), at(1.9, 0, 0, LYING), at(2, 0, 0, 0), at(2.9, 0, 0, 0))
                .forEach(upright::see);
        assertThat(upright.isDecided()).isFalse();
        List.of(at(3, 0, 0, 0), at(8, 0, 0, 0)).forEach(upright::see);

        assertThat(upright.isDecided()).isTrue();
        assertThat(upright.value()).isCloseTo(2, within(1e-9));
    }

    @ParameterizedTest
    @CsvSource({
        "distance-walked, m, true",
        "walk-speed, m/s, true",
        "standing-time, s, true",
        "kick-distance, m, true",
        "get-up-time, s, false",
        "stability, degrees of tilt, false",
        "energy, J, false",
        "time-to-score, s, false"
    })
    void measureSaysUnitAndDirection(String name, String unit, boolean largerIsBetter) {
        Measure measure = Measures.named(name, getClass().getClassLoader()).get();

        assertThat(measure.unit()).isEqualTo(unit);
        assertThat(measure.isLargerBetter()).isEqualTo(largerIsBetter);
        assertThat(measure.isDecided()).isFalse();
    }

    @Test
    void pushesComeInTurnsAndGrow() {
        Pushes pushes = Pushes.growing(1, 10, 5);

        try (Trial trial = Trial.direct(Scene.of(RobotStart.at(0, 0)), 1, Controller.ofSpeeds())) {
            trial.with(pushes).run(0.5);
        }

        assertThat(pushes.count()).isEqualTo(2);
    }

    @Test
    void measureWithoutAFittingConstructorIsRefused() {
        assertThatThrownBy(
                        () -> Measures.named(Failing.class.getName(), getClass().getClassLoader())
                                .get())
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessageContaining("cannot be created: java.lang.IllegalStateException: not today");
        assertThatThrownBy(() -> Measures.named("java.lang.String", getClass().getClassLoader()))
                .hasMessageContaining("A class of your own must implement Measure");
    }

    /** Cannot be created. */
    public static final class Failing implements Measure {

        /** Fails. */
        public Failing() {
            throw new IllegalStateException("not today");
        }

        @Override
        public void see(WorldState state) {}

        @Override
        public double value() {
            return 0;
        }

        @Override
        public String unit() {
            return "";
        }
    }

    private double value(String name, WorldState... states) {
        Measure measure = Measures.named(name, getClass().getClassLoader()).get();
        List.of(states).forEach(measure::see);
        return measure.value();
    }

    private static WorldState at(double seconds, double x, double y, double tiltDegrees) {
        return moment(seconds, pose(x, y, 0.38, 0, tiltDegrees), ASIDE, Vector3.ZERO, 0);
    }

    private static WorldState lifted(double metres) {
        return moment(0, pose(0, 0, 0.38 + metres, 0, 0), ASIDE, Vector3.ZERO, 0);
    }

    private static WorldState ball(double seconds, Vector3 place, Vector3 velocity, int goals) {
        return moment(seconds, pose(0, 0, 0.38, 0, 0), place, velocity, goals);
    }

    private static Pose pose(double x, double y, double height, double headingDegrees, double tiltDegrees) {
        return new Pose(new Vector3(x, y, height), Rotation.ofYawPitchRoll(headingDegrees, tiltDegrees, 0));
    }

    private static WorldState moment(double seconds, Pose torso, Vector3 ball, Vector3 velocity, int goals) {
        BodyState body = BodyState.of(RobotType.TYPE_0, torso, Posture.ZERO);
        return new WorldState(seconds, List.of(body), ball, velocity, List.of(), PlayMode.PLAY_ON, goals, 0);
    }
}
