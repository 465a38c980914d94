package org.robonewbie.competition.contest;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Arrays;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.robonewbie.nao.PlayMode;
import org.robonewbie.nao.TeamSide;
import org.robonewbie.nao.Vector3;
import org.robonewbie.nao.kinematics.BodyState;
import org.robonewbie.nao.kinematics.Pose;
import org.robonewbie.nao.kinematics.Rotation;
import org.robonewbie.nao.model.RobotType;
import org.robonewbie.nao.motion.Posture;
import org.robonewbie.simulator.RobotSnapshot;
import org.robonewbie.simulator.WorldSnapshot;

class PenaltyContestTest {

    private static final List<String> TEAMS = List.of("A", "B");

    /** Goals of both teams, round by round; how many rounds there are to be then. */
    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            nullValues = "none",
            value = {
                "none | 3",
                "1:0 | 3",
                "1:0 1:0 1:0 | 3",
                "1:0 0:1 0:0 | 4",
                "1:1 1:1 1:1 0:0 | 5",
                "1:1 1:1 1:1 1:0 | 4",
                "0:0 0:0 0:0 0:0 0:0 | 5"
            })
    void equalTeamsGoOnOneRoundAfterTheOther(String rounds, int needed) {
        List<ShootOut.Round> played = rounds == null
                ? List.of()
                : Arrays.stream(rounds.split(" ", -1))
                        .map(round -> new ShootOut.Round(round.charAt(0) - '0', round.charAt(2) - '0'))
                        .toList();

        assertThat(new ShootOut(3, 2).roundsNeeded(played)).isEqualTo(needed);
    }

    @Test
    void bothTeamsHaveBothRolesUnderEqualConditions() {
        List<ContestTrial> trials = Contests.penalties(Conditions.of(1), 2, 30).trials(TEAMS, id -> Optional.empty());

        assertThat(trials)
                .extracting(trial ->
                        trial.entrants().get(0).team() + trial.entrants().get(1).team())
                .containsExactly("AB", "BA", "AB", "BA");
        assertThat(trials.get(0).seed()).isEqualTo(trials.get(1).seed());
        assertThat(place(trials.get(0))).isEqualTo(place(trials.get(1))).isNotEqualTo(place(trials.get(2)));
    }

    @Test
    void suddenDeathDecides() {
        Map<String, TrialResult> results = new HashMap<>();
        Contest contest = Contests.penalties(Conditions.of(1), 1, 30);
        play(results, "penalties-A-B-1a", "A", "B", 1);
        play(results, "penalties-A-B-1b", "B", "A", 1);

        assertThat(contest.trials(TEAMS, id -> Optional.ofNullable(results.get(id))))
                .hasSize(4);
        play(results, "penalties-A-B-2a", "A", "B", 0);
        play(results, "penalties-A-B-2b", "B", "A", 1);

        assertThat(contest.trials(TEAMS, id -> Optional.ofNullable(results.get(id))))
                .hasSize(4);
        Table table = contest.table(TEAMS, id -> Optional.ofNullable(results.get(id)));
        assertThat(table.rows()).extracting(Table.Row::team).containsExactly("B", "A");
        assertThat(table.rows().get(0).cells()).containsExactly("1", "1", "0", "0", "2:1", "+1", "3");
    }

    @Test
    void penaltyIsOverWithTheGoalOfTheAttacker() {
        Judge judge = penaltyOfRed();

        boolean early = watch(judge, new Vector3(4, 0, 0.04));
        boolean over = watch(judge, PlayMode.GOAL_LEFT, 1, Vector3.ZERO);

        assertThat(List.of(early, over)).containsExactly(false, true);
        assertThat(judge.figures("Red").get("goals")).isEqualTo(1);
        assertThat(judge.figures("Blue")).isEmpty();
    }

    @Test
    void penaltyIsOverWithoutAGoalWhenTheBallGoesOut() {
        Judge judge = penaltyOfRed();

        boolean over = watch(judge, PlayMode.GOAL_KICK_RIGHT, 0, new Vector3(6, 2, 0.04));

        assertThat(over).isTrue();
        assertThat(judge.figures("Red").get("goals")).isZero();
    }

    @Test
    void keeperThatAsksForPassModeDoesNotEndThePenalty() {
        Judge judge = penaltyOfRed();

        boolean over = watch(judge, PlayMode.PASS_RIGHT, 0, new Vector3(4, 0, 0.04));

        assertThat(over).isFalse();
    }

    private static Judge penaltyOfRed() {
        JudgedContest contest = Contests.penalties(Conditions.of(1), 3, 30);
        ContestTrial trial = contest.trials(List.of("Red", "Blue"), id -> Optional.empty()).stream()
                .filter(attack -> attack.entrants().get(0).team().equals("Red"))
                .findFirst()
                .orElseThrow();
        return contest.judge(trial);
    }

    private static boolean watch(Judge judge, Vector3 ball) {
        return watch(judge, PlayMode.PLAY_ON, 0, ball);
    }

    /** Shows a judge the attacker, alone on the pitch. */
    private static boolean watch(Judge judge, PlayMode mode, int goals, Vector3 ball) {
        Pose torso = new Pose(new Vector3(3, 0, 0.38), Rotation.NONE);
        BodyState body = BodyState.of(RobotType.TYPE_0, torso, Posture.ZERO);
        RobotSnapshot robot = new RobotSnapshot(1, "Red", Optional.of(TeamSide.LEFT), 2, body);
        return judge.watch(new WorldSnapshot(
                1, 0.02, mode, "Red", "", goals, 0, 1, ball, Rotation.NONE, List.of(robot), List.of(), false, 1, 1));
    }

    private static void play(
            Map<String, TrialResult> results, String id, String attacker, String keeper, double goals) {
        results.put(
                id,
                new TrialResult(
                        id,
                        1,
                        30,
                        List.of(
                                TeamResult.of(attacker, Ending.PLAYED, Map.of(Judge.GOALS, goals)),
                                TeamResult.of(keeper, Ending.PLAYED, Map.of()))));
    }

    private static StartPlace place(ContestTrial trial) {
        return trial.entrants().get(0).places().get(0);
    }
}
