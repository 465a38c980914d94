package org.robonewbie.learning.objective;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.robonewbie.nao.Vector3;
import org.robonewbie.nao.motion.Posture;

class StandardObjectiveTest {

    private static final Vector3 ASIDE = new Vector3(0, -3, 0.042);

    @Test
    void distanceCountsAlongTheFirstHeadingOnly() {
        double metres = value(StandardObjective.DISTANCE_WALKED, at(0, 0, 0, 1), at(1, 2, 0.5, 1));

        assertThat(metres).isCloseTo(2, within(1e-9));
    }

    @Test
    void distanceEndsWithTheFall() {
        double metres = value(
                StandardObjective.DISTANCE_WALKED, at(0, 0, 0, 1), at(1, 1, 0, 1), at(2, 2, 0, 0.1), at(3, 3, 0, 1));

        assertThat(metres).isCloseTo(1, within(1e-9));
    }

    @Test
    void speedIsSlowerForTheTimeOnTheGround() {
        double speed = value(StandardObjective.WALK_SPEED, at(0, 0, 0, 1), at(1, 1, 0, 1), at(4, 2, 0, 0.1));

        assertThat(speed).isCloseTo(0.25, within(1e-9));
    }

    @Test
    void stabilityIsTheMeanTilt() {
        double degrees = value(StandardObjective.STABILITY, at(0, 0, 0, 1), at(1, 0, 0, Math.cos(Math.toRadians(30))));

        assertThat(degrees).isCloseTo(15, within(1e-6));
    }

    @Test
    void aFallIsAsBadForStabilityAsLying() {
        double degrees = value(StandardObjective.STABILITY, at(0, 0, 0, 0.1), at(1, 0, 0, 1));

        assertThat(degrees).isCloseTo(90, within(1e-9));
    }

    @Test
    void energyIsWhatTheTrialNeeded() {
        double joules = value(StandardObjective.ENERGY, working(3), working(8));

        assertThat(joules).isCloseTo(5, within(1e-9));
    }

    @Test
    void kickDistanceCountsWhatTheBallWillRollOn() {
        double metres = value(
                StandardObjective.KICK_DISTANCE,
                ball(0, new Vector3(0.2, 0, 0.042), Vector3.ZERO, 6, false),
                ball(1, new Vector3(1.2, 0.1, 0.042), new Vector3(2, 0, 0), 5, false));

        assertThat(metres).isCloseTo(1 + 2 * 0.94, within(1e-9));
    }

    @Test
    void timeToScoreIsThatOfTheFirstGoal() {
        double seconds = value(
                StandardObjective.TIME_TO_SCORE,
                ball(0, ASIDE, Vector3.ZERO, 6, false),
                ball(7, ASIDE, Vector3.ZERO, 0, true),
                ball(9, ASIDE, Vector3.ZERO, 0, true));

        assertThat(seconds).isCloseTo(7, within(1e-9));
    }

    @Test
    void aBallThatIsNearTheGoalIsBetterThanOneThatIsFar() {
        double near = value(StandardObjective.TIME_TO_SCORE, ball(9, ASIDE, Vector3.ZERO, 1, false));
        double far = value(StandardObjective.TIME_TO_SCORE, ball(9, ASIDE, Vector3.ZERO, 2, false));

        assertThat(near).isLessThan(far);
    }

    @Test
    void isFoundByItsLabel() {
        assertThat(StandardObjective.labelled("kick-distance")).isEqualTo(StandardObjective.KICK_DISTANCE);
    }

    @Test
    void namesAllObjectivesIfThereIsNoneOfAName() {
        assertThatThrownBy(() -> StandardObjective.labelled("speed"))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessage(
                        "There is no objective \"speed\". There are: distance-walked, walk-speed, energy, stability,"
                                + " kick-distance, time-to-score.");
    }

    private static double value(Objective objective, TrueState... states) {
        Gauge gauge = objective.gauge();
        List.of(states).forEach(gauge::look);
        return gauge.value();
    }

    private static TrueState at(double seconds, double x, double y, double uprightness) {
        return new TrueState(
                seconds,
                new Vector3(x, y, 0.39),
                Vector3.ZERO,
                0,
                uprightness,
                Vector3.ZERO,
                Posture.ZERO,
                0,
                ASIDE,
                Vector3.ZERO,
                6,
                false);
    }

    private static TrueState working(double joules) {
        TrueState state = at(0, 0, 0, 1);
        return new TrueState(
                state.seconds(),
                state.torso(),
                state.velocity(),
                0,
                1,
                state.turning(),
                state.joints(),
                joules,
                state.ball(),
                state.ballVelocity(),
                6,
                false);
    }

    private static TrueState ball(double seconds, Vector3 ball, Vector3 velocity, double toGoal, boolean scored) {
        TrueState state = at(seconds, 0, 0, 1);
        return new TrueState(
                seconds,
                state.torso(),
                state.velocity(),
                0,
                1,
                state.turning(),
                state.joints(),
                0,
                ball,
                velocity,
                toGoal,
                scored);
    }
}
