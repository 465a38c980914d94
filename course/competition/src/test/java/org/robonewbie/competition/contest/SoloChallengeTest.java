package org.robonewbie.competition.contest;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.entry;
import static org.assertj.core.api.Assertions.offset;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.robonewbie.nao.Cycle;
import org.robonewbie.nao.PlayMode;
import org.robonewbie.nao.Vector3;
import org.robonewbie.nao.geometry.Pose2d;
import org.robonewbie.nao.kinematics.BodyState;
import org.robonewbie.nao.kinematics.Pose;
import org.robonewbie.nao.kinematics.Rotation;
import org.robonewbie.nao.model.RobotType;
import org.robonewbie.nao.motion.Posture;
import org.robonewbie.trial.Challenge;
import org.robonewbie.trial.RandomSource;
import org.robonewbie.trial.Scene;
import org.robonewbie.trial.WorldState;

/** What contests for one robot measure in moments that are put together by hand: the robot, the ball, a decision of the referee. */
class SoloChallengeTest {

    private static final Conditions CONDITIONS = Conditions.of(1);
    private static final double STANDING = 0.38;
    private static final Vector3 FAR_AWAY = new Vector3(3, 3, 0.04);

    private Challenge challenge = challenge(Contests.walk(CONDITIONS));
    private long cycle;

    @Test
    void walkEndsWhenTheLineIsCrossedUpright() {
        challenge = challenge(Contests.walk(CONDITIONS));
        see(robotAt(-4, STANDING, 0), FAR_AWAY);

        boolean early = see(robotAt(-4 + 1.5, STANDING, 0), FAR_AWAY);
        boolean lying = see(robotAt(-4 + 3.5, 0.1, 90), FAR_AWAY);
        boolean over = see(robotAt(-4 + 3.1, STANDING, 0), FAR_AWAY);

        assertThat(List.of(early, lying, over)).containsExactly(false, false, true);
        assertThat(challenge.figures()).containsOnly(entry("lineSeconds", 0.06), entry("wayMetres", 3.0));
    }

    @Test
    void wayOfAFallenRobotDoesNotCount() {
        challenge = challenge(Contests.walk(CONDITIONS));
        see(robotAt(-4, STANDING, 0), FAR_AWAY);

        see(robotAt(-4 + 1.5, STANDING, 0), FAR_AWAY);
        see(robotAt(-4 + 2.5, 0.1, 90), FAR_AWAY);

        assertThat(challenge.figures()).containsOnlyKeys("wayMetres");
        assertThat(figure("wayMetres")).isCloseTo(1.5, offset(1e-6));
    }

    @Test
    void kickCountsFromWhereTheBallLeftTheRobot() {
        challenge = challenge(Contests.kick(CONDITIONS));

        see(robotAt(0.8, STANDING, 0), new Vector3(1, 0, 0.04));
        see(robotAt(0.8, STANDING, 0), new Vector3(4, 0, 0.04));
        see(robotAt(0.8, STANDING, 0), new Vector3(3.5, 0, 0.04));

        assertThat(figure("kickMetres")).isEqualTo(3);
    }

    @Test
    void ballThatTheRefereeCarriesAwayIsNoKick() {
        challenge = challenge(Contests.kick(CONDITIONS));

        see(robotAt(0.8, STANDING, 0), new Vector3(1, 0, 0.04));
        boolean over = see(PlayMode.KICK_IN_RIGHT, 0, robotAt(0.8, STANDING, 0), new Vector3(5, 4, 0.04));

        assertThat(over).isTrue();
        assertThat(figure("kickMetres")).isZero();
    }

    @Test
    void goalEndsTheTrialAndWithoutOneThePlaceOfTheBallAtTheEndCounts() {
        challenge = challenge(Contests.scoring(CONDITIONS, 180));
        see(robotAt(0, STANDING, 0), Vector3.ZERO);

        see(robotAt(0, STANDING, 0), new Vector3(5, 0, 0.04));
        see(robotAt(0, STANDING, 0), new Vector3(-2, 0, 0.04));
        double atTheEnd = figure("ballMetres");
        double closest = figure("closestMetres");
        boolean over = see(PlayMode.GOAL_LEFT, 1, robotAt(0, STANDING, 0), Vector3.ZERO);

        assertThat(atTheEnd).isEqualTo(8);
        assertThat(closest).isEqualTo(1);
        assertThat(over).isTrue();
        assertThat(challenge.figures())
                .containsOnly(entry("ballMetres", 0.0), entry("closestMetres", 0.0), entry("goalSeconds", 0.06));
    }

    @Test
    void standingEndsWithTheFall() {
        challenge = challenge(Contests.stand(CONDITIONS));
        see(robotAt(-2, STANDING, 0), FAR_AWAY);

        boolean standing = see(robotAt(-2, STANDING, 0), FAR_AWAY);
        boolean leaning = see(robotAt(-2, STANDING, 50), FAR_AWAY);
        boolean lying = see(robotAt(-2, 0.1, 80), FAR_AWAY);

        assertThat(List.of(standing, leaning, lying)).containsExactly(false, false, true);
        assertThat(challenge.figures()).contains(entry("standingSeconds", 0.04), entry("pushes", 0.0));
    }

    @Test
    void bowHasToBeHeldForASecond() {
        challenge = challenge(Contests.gymnastics(CONDITIONS));

        for (int i = 0; i < 50; i++) {
            see(robotAt(-2, 0.33, 40), FAR_AWAY);
        }
        double tooShort = figure("elements");
        see(robotAt(-2, 0.33, 40), FAR_AWAY);

        assertThat(tooShort).isZero();
        assertThat(figure("elements")).isEqualTo(1);
    }

    @Test
    void gettingUpNeedsLyingBefore() {
        challenge = challenge(Contests.gymnastics(CONDITIONS));

        for (int i = 0; i < 60; i++) {
            see(robotAt(-2, STANDING, 0), FAR_AWAY);
        }
        double standingOnly = figure("elements");
        for (int i = 0; i < 60; i++) {
            see(robotAt(-2, 0.1, 90), FAR_AWAY);
        }
        for (int i = 0; i < 60; i++) {
            see(robotAt(-2, STANDING, 0), FAR_AWAY);
        }

        assertThat(standingOnly).isZero();
        assertThat(figure("elements")).isEqualTo(1);
    }

    @Test
    void fullTurnCountsOnTheFeetOnly() {
        challenge = challenge(Contests.gymnastics(CONDITIONS));

        for (int degrees = 0; degrees <= 355; degrees += 5) {
            see(body(-2, STANDING, 0, degrees), FAR_AWAY);
        }
        for (int degrees = 355; degrees <= 400; degrees += 5) {
            see(body(-2, 0.1, 70, degrees), FAR_AWAY);
        }
        see(robotAt(-2, STANDING, 0), FAR_AWAY);
        double afterTheFall = figure("elements");
        see(body(-2, STANDING, 0, 5), FAR_AWAY);

        assertThat(afterTheFall).isZero();
        assertThat(figure("elements")).isEqualTo(1);
    }

    @Test
    void lastElementTellsItsTime() {
        challenge = challenge(Contests.gymnastics(CONDITIONS));

        for (int i = 0; i <= 60; i++) {
            see(robotAt(-2, 0.28, 0), FAR_AWAY);
        }

        assertThat(challenge.figures()).containsOnly(entry("elements", 1.0), entry("lastSeconds", 1.0));
    }

    @Test
    void robotStartsWhereItsProgramIsTold() {
        Conditions varied = new Conditions(3, true, Map.of());
        Contest contest = Contests.scoring(varied, 180);

        StartPlace told = contest.trials(List.of("Red"), id -> Optional.empty())
                .get(0)
                .entrants()
                .get(0)
                .places()
                .get(0);
        Scene scene = challenge(contest).scene(new RandomSource(3));

        assertThat(scene.robots().get(0).place()).isEqualTo(new Pose2d(told.x(), told.y(), told.degrees()));
        assertThat(scene.robots().get(0).number()).isEqualTo(told.number());
        assertThat(told).isNotEqualTo(new StartPlace(2, -0.5, 0.4, -40));
    }

    private double figure(String name) {
        return challenge.figures().getOrDefault(name, Double.NaN);
    }

    private static Challenge challenge(Contest contest) {
        return ((ChallengeContest) contest).challenge().get();
    }

    private boolean see(BodyState robot, Vector3 ball) {
        return see(PlayMode.PLAY_ON, 0, robot, ball);
    }

    private boolean see(PlayMode mode, int goals, BodyState robot, Vector3 ball) {
        challenge.see(
                new WorldState(cycle * Cycle.SECONDS, List.of(robot), ball, Vector3.ZERO, List.of(), mode, goals, 0));
        cycle++;
        return challenge.isDecided();
    }

    /** A robot that faces the right goal, leaning to the front; the joints are at 0. */
    private static BodyState robotAt(double x, double height, double leanDegrees) {
        return body(x, height, leanDegrees, 0);
    }

    private static BodyState body(double x, double height, double leanDegrees, double heading) {
        Pose torso = new Pose(new Vector3(x, 0, height), Rotation.ofYawPitchRoll(heading, leanDegrees, 0));
        return BodyState.of(RobotType.TYPE_0, torso, Posture.ZERO);
    }
}
