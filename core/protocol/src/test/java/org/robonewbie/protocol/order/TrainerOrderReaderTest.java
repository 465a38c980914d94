package org.robonewbie.protocol.order;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatCode;
import static org.robonewbie.protocol.monitor.RecordedMonitorMessages.message;

import java.util.List;
import java.util.Optional;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.robonewbie.nao.PlayMode;
import org.robonewbie.nao.TeamSide;
import org.robonewbie.nao.Vector3;

class TrainerOrderReaderTest {

    private static final PlayerNumber LEFT_3 = new PlayerNumber(TeamSide.LEFT, 3);

    @Test
    void commandForAPlayerOfNoTeamIsLeftOut() {
        assertThat(read("(select (unum 2))(select (unum 2)(team))(kill (unum 2)(team Blue))"))
                .isEmpty();
    }

    @Test
    void kickOffNamesTheTeamOrNone() {
        assertThat(read("(kickOff Left)(kickOff Right)(kickOff None)"))
                .containsExactly(
                        new Order.KickOff(Optional.of(TeamSide.LEFT)),
                        new Order.KickOff(Optional.of(TeamSide.RIGHT)),
                        new Order.KickOff(Optional.empty()));
    }

    @Test
    void playModesAreKnownByTheirExactNames() {
        assertThat(read("(playMode PlayOn)(playMode playon)(playMode corner_kick_left)"))
                .containsExactly(
                        new Order.ChangePlayMode(PlayMode.PLAY_ON),
                        new Order.ChangePlayMode(PlayMode.CORNER_KICK_LEFT));
    }

    @Test
    void ballMayBeMovedOrPushedOrBoth() {
        assertThat(read("(ball (pos 1 -2 0.5))(ball (vel 3 0 1e-1))(ball (vel 1 2 3) (pos 0 0 0))"))
                .containsExactly(
                        new Order.MoveBall(Optional.of(new Vector3(1, -2, 0.5)), Optional.empty()),
                        new Order.MoveBall(Optional.empty(), Optional.of(new Vector3(3, 0, 0.1))),
                        new Order.MoveBall(Optional.of(Vector3.ZERO), Optional.of(new Vector3(1, 2, 3))));
    }

    @Test
    void severalCommandsFitInOneMessageAsLeagueTeamsSendThem() {
        assertThat(read("(playMode PlayOn) (ball (pos 0 -9 0) (vel 0 0 0))")).hasSize(2);
    }

    @Test
    void robotIsMovedWithAndWithoutTurning() {
        assertThat(read("(agent (unum 3)(team Left)(pos 1 2 0.4))(agent (team Left)(unum 3)(move 1 2 0.4 -90))"))
                .containsExactly(
                        new Order.MoveRobot(LEFT_3, new Vector3(1, 2, 0.4)),
                        new Order.MoveAndTurnRobot(LEFT_3, new Vector3(1, 2, 0.4), -90));
    }

    @Test
    void agentWithoutNumberOrTeamMeansTheSelectedRobot() {
        assertThat(read("(agent (pos 1 2 3))(agent (unum 3))(agent (team Left))"))
                .hasSize(3)
                .containsOnly(new Order.RepelSelectedRobot());
    }

    @Test
    void selectionGoesToOneRobotTheNextOrNone() {
        assertThat(read("(select (unum 3)(team Left))(select)(select (unum -1))"))
                .containsExactly(new Order.SelectRobot(LEFT_3), new Order.SelectNextRobot(), new Order.SelectNoRobot());
    }

    @Test
    void killAndRepositionMeanTheNamedOrTheSelectedRobot() {
        assertThat(read("(kill (unum 3)(team Left))(kill)(repos (unum 3)(team Left))(repos)"))
                .containsExactly(
                        new Order.KillRobot(Optional.of(LEFT_3)),
                        new Order.KillRobot(Optional.empty()),
                        new Order.RepositionRobot(Optional.of(LEFT_3)),
                        new Order.RepositionRobot(Optional.empty()));
    }

    @Test
    void plainCommandsAreKnown() {
        assertThat(read("(dropBall)(killsim)(reqfullstate)(time 12.5)(score (left 2)(right 1))"))
                .containsExactly(
                        new Order.DropBall(),
                        new Order.EndSimulation(),
                        new Order.RequestFullState(),
                        new Order.SetTime(12.5),
                        new Order.SetScore(2, 1));
    }

    @ParameterizedTest
    @ValueSource(
            strings = {
                "",
                "(init)",
                "(getAck)",
                "(kickOff)",
                "(kickOff left)",
                "(playMode)",
                "(playMode Bounce)",
                "(ball)",
                "(ball (pos 1 2))",
                "(ball (pos 1 2 3 4))",
                "(ball (pos nan 0 0))",
                "(ball (pos 1e308 0 0)(vel inf 0 0))",
                "(ball (pos 1 2 3)",
                "(agent (unum 3)(team None)(pos 1 2 3))",
                "(agent (unum 3)(team Left)(move 1 2 3))",
                "(agent (unum 3)(team Left)(battery 50))",
                "(select (unum 3)(team left))",
                "(time -1)",
                "(time nan)",
                "(score (left 1))",
                "(score (left -1)(right 0))",
                "ball (",
                ")(dropBall)",
                "()(()((",
                "; (dropBall)"
            })
    void unknownAndIncompleteCommandsAreLeftOut(String text) {
        assertThat(read(text)).isEmpty();
    }

    @Test
    void unknownCommandDoesNotHideTheNextOne() {
        assertThat(read("(init)(dance (with me)) word (()) (dropBall)")).containsExactly(new Order.DropBall());
    }

    @Test
    void textThatIsNoNumberCountsAsZero() {
        assertThat(read("(ball (pos here 1x +2))"))
                .containsExactly(new Order.MoveBall(Optional.of(new Vector3(0, 1, 2)), Optional.empty()));
    }

    @Test
    void parenthesesNestedHundredThousandDeepDoNoHarm() {
        assertThat(read("(ball ".repeat(100_000))).isEmpty();
        assertThat(read("(".repeat(100_000) + ")".repeat(100_000) + "(dropBall)"))
                .containsExactly(new Order.DropBall());
    }

    @Test
    void randomBytesNeverStopTheReader() {
        Random random = new Random(11);
        String letters = "()()  ballposvelagentunumteamLeft0123456789.-+einf;\"\n\u0128";
        for (int i = 0; i < 20_000; i++) {
            StringBuilder text = new StringBuilder("(ball (pos ");
            for (int k = random.nextInt(60); k >= 0; k--) {
                text.append(letters.charAt(random.nextInt(letters.length())));
            }
            String garbage = text.toString();
            assertThatCode(() -> read(garbage)).as(garbage).doesNotThrowAnyException();
        }
    }

    private static List<Order.Trainer> read(String text) {
        return new TrainerOrderReader().read(message(text));
    }
}
