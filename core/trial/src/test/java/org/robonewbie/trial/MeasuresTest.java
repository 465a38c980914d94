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
import org.robonewbie.nao.PlayMode;
import org.robonewbie.nao.Vector3;
import org.robonewbie.nao.kinematics.BodyState;
import org.robonewbie.nao.kinematics.Pose;
import org.robonewbie.nao.kinematics.Rotation;
import org.robonewbie.nao.model.RobotType;
import org.robonewbie.nao.motion.Posture;
import org.robonewbie.trial.measure.Energy;
import org.robonewbie.trial.measure.Measures;
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
                        "There is no measure \"speed\". Did you mean walk-speed? There are: distance-walked, energy, get-up-time,"
                                + " kick-distance, stability, standing-time, time-to-score, walk-speed.");
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
                    .hasMessageStartingWith("A jar or folder offers a Measure that cannot be loaded: ");
        }
    }

    @Test
    void anyClassCanBeAMeasure() {
        Measure measure = Measures.named(Turn.class.getName(), getClass().getClassLoader())
                .get();

        assertThat(measure).isInstanceOf(Turn.class);
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
        return new WorldState(seconds, List.of(body), ball, velocity, PlayMode.PLAY_ON, goals, 0);
    }
}
