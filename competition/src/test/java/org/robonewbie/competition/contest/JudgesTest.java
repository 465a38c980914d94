package org.robonewbie.competition.contest;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.entry;
import static org.assertj.core.api.Assertions.offset;

import java.io.IOException;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.robonewbie.nao.Cycle;
import org.robonewbie.nao.PlayMode;
import org.robonewbie.nao.TeamSide;
import org.robonewbie.nao.Vector3;
import org.robonewbie.nao.kinematics.BodyState;
import org.robonewbie.nao.kinematics.Pose;
import org.robonewbie.nao.kinematics.Rotation;
import org.robonewbie.nao.model.RobotType;
import org.robonewbie.nao.motion.Posture;
import org.robonewbie.simulator.Console;
import org.robonewbie.simulator.RobotSnapshot;
import org.robonewbie.simulator.WorldSnapshot;
import org.robonewbie.simulator.server.Simulator;
import org.robonewbie.simulator.server.SimulatorSettings;
import org.robonewbie.simulator.soccer.SoccerParameters;

/** What the judges see in worlds that are put together by hand: one robot, the ball, a decision of the referee. */
class JudgesTest {

    private static final double STANDING = 0.38;
    private static final Vector3 FAR_AWAY = new Vector3(3, 3, 0.04);

    private ContestTrial trial =
            new ContestTrial("none", 1, SoccerParameters.beginner(), List.of(), 1, TeamSide.LEFT, Optional.empty());

    private Simulator simulator;
    private long cycle;

    @BeforeEach
    void openPitch() throws IOException {
        simulator = Simulator.start(
                SimulatorSettings.beginner().agentPort(0).awaitedAgents(1).build(), Console.silent());
    }

    @AfterEach
    void closePitch() {
        simulator.close();
    }

    @Test
    void walkEndsWhenTheLineIsCrossedUpright() {
        Judge judge = judge(Contests.walk(conditions()));

        boolean early = watch(judge, robotAt(-4 + 1.5, STANDING, 0), FAR_AWAY);
        boolean lying = watch(judge, robotAt(-4 + 3.5, 0.1, 90), FAR_AWAY);
        boolean over = watch(judge, robotAt(-4 + 3.1, STANDING, 0), FAR_AWAY);

        assertThat(List.of(early, lying, over)).containsExactly(false, false, true);
        assertThat(judge.figures("Red")).containsOnly(entry("lineSeconds", 0.06), entry("wayMetres", 3.0));
    }

    @Test
    void wayOfAFallenRobotDoesNotCount() {
        Judge judge = judge(Contests.walk(conditions()));

        watch(judge, robotAt(-4 + 1.5, STANDING, 0), FAR_AWAY);
        watch(judge, robotAt(-4 + 2.5, 0.1, 90), FAR_AWAY);

        assertThat(judge.figures("Red")).containsOnlyKeys("wayMetres");
        assertThat(figure(judge, "wayMetres")).isCloseTo(1.5, offset(1e-6));
    }

    @Test
    void kickCountsFromWhereTheBallLeftTheRobot() {
        Judge judge = judge(Contests.kick(conditions()));

        watch(judge, robotAt(0.8, STANDING, 0), new Vector3(1, 0, 0.04));
        watch(judge, robotAt(0.8, STANDING, 0), new Vector3(4, 0, 0.04));
        watch(judge, robotAt(0.8, STANDING, 0), new Vector3(3.5, 0, 0.04));

        assertThat(figure(judge, "kickMetres")).isEqualTo(3);
    }

    @Test
    void ballThatTheRefereeCarriesAwayIsNoKick() {
        Judge judge = judge(Contests.kick(conditions()));

        watch(judge, robotAt(0.8, STANDING, 0), new Vector3(1, 0, 0.04));
        boolean over = watch(judge, PlayMode.KICK_IN_RIGHT, 0, robotAt(0.8, STANDING, 0), new Vector3(5, 4, 0.04));

        assertThat(over).isTrue();
        assertThat(judge.figures("Red")).isEmpty();
    }

    @Test
    void goalEndsTheTrialAndNearestBallIsKept() {
        Judge judge = judge(Contests.scoring(conditions(), 180));

        watch(judge, robotAt(0, STANDING, 0), new Vector3(5, 0, 0.04));
        watch(judge, robotAt(0, STANDING, 0), new Vector3(-2, 0, 0.04));
        double nearest = figure(judge, "ballMetres");
        boolean over = watch(judge, PlayMode.GOAL_LEFT, 1, robotAt(0, STANDING, 0), Vector3.ZERO);

        assertThat(nearest).isEqualTo(1);
        assertThat(over).isTrue();
        assertThat(judge.figures("Red")).containsOnly(entry("ballMetres", 0.0), entry("goalSeconds", 0.06));
    }

    @Test
    void penaltyIsOverWithTheGoalOfTheAttacker() {
        Judge judge = penaltyOfRed();

        boolean early = watch(judge, robotAt(3, STANDING, 0), new Vector3(4, 0, 0.04));
        boolean over = watch(judge, PlayMode.GOAL_LEFT, 1, robotAt(3, STANDING, 0), Vector3.ZERO);

        assertThat(List.of(early, over)).containsExactly(false, true);
        assertThat(figure(judge, "goals")).isEqualTo(1);
        assertThat(judge.figures("Blue")).isEmpty();
    }

    @Test
    void penaltyIsOverWithoutAGoalWhenTheBallGoesOut() {
        Judge judge = penaltyOfRed();

        boolean over = watch(judge, PlayMode.GOAL_KICK_RIGHT, 0, robotAt(3, STANDING, 0), new Vector3(6, 2, 0.04));

        assertThat(over).isTrue();
        assertThat(figure(judge, "goals")).isZero();
    }

    private Judge penaltyOfRed() {
        JudgedContest contest = Contests.penalties(conditions(), 3, 30);
        trial = contest.trials(List.of("Red", "Blue"), id -> Optional.empty()).stream()
                .filter(attack -> attack.entrants().get(0).team().equals("Red"))
                .findFirst()
                .orElseThrow();
        return contest.judge(trial);
    }

    @Test
    void standingEndsWithTheFall() {
        Judge judge = judge(Contests.stand(conditions()));

        boolean standing = watch(judge, robotAt(-2, STANDING, 0), FAR_AWAY);
        boolean leaning = watch(judge, robotAt(-2, STANDING, 50), FAR_AWAY);
        boolean lying = watch(judge, robotAt(-2, 0.1, 80), FAR_AWAY);

        assertThat(List.of(standing, leaning, lying)).containsExactly(false, false, true);
        assertThat(judge.figures("Red")).contains(entry("standingSeconds", 0.04), entry("pushes", 0.0));
    }

    @Test
    void bowHasToBeHeldForASecond() {
        Judge judge = judge(Contests.gymnastics(conditions()));

        for (int i = 0; i < 49; i++) {
            watch(judge, robotAt(-2, 0.33, 40), FAR_AWAY);
        }
        double tooShort = figure(judge, "elements");
        watch(judge, robotAt(-2, 0.33, 40), FAR_AWAY);

        assertThat(tooShort).isZero();
        assertThat(figure(judge, "elements")).isEqualTo(1);
    }

    @Test
    void gettingUpNeedsLyingBefore() {
        Judge judge = judge(Contests.gymnastics(conditions()));

        for (int i = 0; i < 60; i++) {
            watch(judge, robotAt(-2, STANDING, 0), FAR_AWAY);
        }
        double standingOnly = figure(judge, "elements");
        for (int i = 0; i < 60; i++) {
            watch(judge, robotAt(-2, 0.1, 90), FAR_AWAY);
        }
        for (int i = 0; i < 60; i++) {
            watch(judge, robotAt(-2, STANDING, 0), FAR_AWAY);
        }

        assertThat(standingOnly).isZero();
        assertThat(figure(judge, "elements")).isEqualTo(1);
    }

    private static double figure(Judge judge, String name) {
        return judge.figures("Red").getOrDefault(name, Double.NaN);
    }

    private static Conditions conditions() {
        return new Conditions(1, false, Map.of());
    }

    private Judge judge(JudgedContest contest) {
        trial = contest.trials(List.of("Red"), id -> Optional.empty()).get(0);
        return contest.judge(trial);
    }

    private boolean watch(Judge judge, RobotSnapshot robot, Vector3 ball) {
        return watch(judge, PlayMode.PLAY_ON, 0, robot, ball);
    }

    private boolean watch(Judge judge, PlayMode mode, int goals, RobotSnapshot robot, Vector3 ball) {
        cycle++;
        double seconds = cycle * Cycle.SECONDS;
        WorldSnapshot world = new WorldSnapshot(
                cycle, seconds, mode, "Red", "", goals, 0, 1, ball, Rotation.NONE, List.of(robot), false, 1, 1);
        return judge.watch(new JudgedMoment(trial, seconds, world), simulator.control());
    }

    /** A robot that faces the right goal, leaning to the front; the joints are at 0. */
    private static RobotSnapshot robotAt(double x, double height, double leanDegrees) {
        Pose torso = new Pose(new Vector3(x, 0, height), Rotation.ofYawPitchRoll(0, leanDegrees, 0));
        BodyState body = BodyState.of(RobotType.TYPE_0, torso, Posture.ZERO);
        return new RobotSnapshot(1, "Red", Optional.of(TeamSide.LEFT), 2, body);
    }
}
