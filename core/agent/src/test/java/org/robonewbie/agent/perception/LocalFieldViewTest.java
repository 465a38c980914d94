package org.robonewbie.agent.perception;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.io.OutputStream;
import java.io.PrintStream;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import org.junit.jupiter.api.Test;
import org.robonewbie.agent.log.Diagnostics;
import org.robonewbie.nao.BodyPart;
import org.robonewbie.nao.FieldMarking;
import org.robonewbie.nao.Landmark;
import org.robonewbie.nao.TeamSide;
import org.robonewbie.nao.Vector3;
import org.robonewbie.protocol.perceptor.PolarPosition;
import org.robonewbie.protocol.perceptor.Vision;
import org.robonewbie.protocol.perceptor.Vision.SeenBodyPart;
import org.robonewbie.protocol.perceptor.Vision.SeenLandmark;
import org.robonewbie.protocol.perceptor.Vision.SeenLine;
import org.robonewbie.protocol.perceptor.Vision.SeenMarking;
import org.robonewbie.protocol.perceptor.Vision.SeenPlayer;

class LocalFieldViewTest {

    private final Diagnostics diagnostics = new Diagnostics(new PrintStream(OutputStream.nullOutputStream()));
    private final FieldMemory view = new FieldMemory(diagnostics);

    @Test
    void knowsNothingAtFirst() {
        FieldItem ball = view.ball();

        assertThat(ball.isKnown()).isFalse();
        assertThat(ball.isVisible()).isFalse();
        assertThat(ball.ageSeconds()).isInfinite();
        assertThat(ball.distance()).isInfinite();
        assertThat(view.landmark(Landmark.FLAG_1_LEFT).isKnown()).isFalse();
        assertThat(view.players()).isEmpty();
        assertThat(view.lines()).isEmpty();
        assertThat(diagnostics.reported()).isEmpty();
    }

    @Test
    void reportsWhoAsksForTheDirectionOfSomethingNeverSeen() {
        double bearing = view.ball().bearing();

        assertThat(bearing).isZero();
        assertThat(diagnostics.reported())
                .singleElement()
                .asString()
                .startsWith("0.00 s: The bearing of the ball is unknown, since it has never been seen; call isKnown()"
                        + " first.");
    }

    @Test
    void takesTheTurnedHeadIntoAccount() {
        view.setTime(1);
        view.see(ball(2, 10, -5), 30, -20);

        assertThat(view.ball().distanceFromHead()).isEqualTo(2);
        assertThat(view.ball().distance()).isCloseTo(2 * Math.cos(Math.toRadians(25)), within(1e-9));
        assertThat(view.ball().bearing()).isEqualTo(40);
        assertThat(view.ball().elevation()).isEqualTo(-25);
    }

    @Test
    void remembersMarkingsOfTheLeaguesPitch() {
        view.setTime(1);
        view.see(
                new Vision(
                        List.of(),
                        Optional.empty(),
                        List.of(),
                        List.of(),
                        Optional.empty(),
                        OptionalDouble.empty(),
                        Optional.empty(),
                        List.of(new SeenMarking(FieldMarking.PENALTY_SPOT_RIGHT, new PolarPosition(5, 10, 0)))),
                0,
                0);

        assertThat(view.marking(FieldMarking.PENALTY_SPOT_RIGHT).bearing()).isEqualTo(10);
        assertThat(view.marking(FieldMarking.PENALTY_SPOT_LEFT).isKnown()).isFalse();
    }

    @Test
    void remembersTheBallWhenTheHeadHasTurnedAway() {
        view.setTime(1);
        view.see(ball(2, 0, 0), 0, 0);
        view.setTime(1.06);
        view.see(Vision.NOTHING, 90, 0);

        assertThat(view.ball().isKnown()).isTrue();
        assertThat(view.ball().isVisible()).isFalse();
        assertThat(view.ball().ageSeconds()).isCloseTo(0.06, within(1e-9));
        assertThat(view.ball().lastSeenSeconds()).isEqualTo(1);
        assertThat(view.ball().distance()).isEqualTo(2);
    }

    @Test
    void staysVisibleBetweenTwoPictures() {
        view.setTime(1);
        view.see(ball(2, 0, 0), 0, 0);
        view.setTime(1.04);

        assertThat(view.ball().isVisible()).isTrue();
    }

    @Test
    void isNoLongerVisibleWhenTheCameraSendsNothingMore() {
        view.setTime(1);
        view.see(ball(2, 0, 0), 0, 0);
        view.setTime(1.2);

        assertThat(view.ball().isVisible()).isFalse();
    }

    @Test
    void namesThePostsOfTheOpponentsGoalAsTheOwnTeamSeesThem() {
        view.setIdentity("Blue", 1, TeamSide.LEFT);
        FieldItem leftAsLeftTeam = view.opponentGoalLeftPost();
        view.setIdentity("Blue", 1, TeamSide.RIGHT);
        FieldItem leftAsRightTeam = view.opponentGoalLeftPost();

        assertThat(leftAsLeftTeam).isSameAs(view.landmark(Landmark.GOAL_POST_1_RIGHT));
        assertThat(leftAsRightTeam).isSameAs(view.landmark(Landmark.GOAL_POST_2_LEFT));
        assertThat(view.opponentGoalRightPost()).isSameAs(view.landmark(Landmark.GOAL_POST_1_LEFT));
        assertThat(view.ownGoalLeftPost()).isSameAs(view.landmark(Landmark.GOAL_POST_1_RIGHT));
        assertThat(view.ownGoalRightPost()).isSameAs(view.landmark(Landmark.GOAL_POST_2_RIGHT));
    }

    @Test
    void meetsOthersButNotItself() {
        view.setIdentity("Blue", 1, TeamSide.LEFT);
        view.setTime(1);
        view.see(players(player("Blue", 1), player("Blue", 2), player("Red", 1)), 0, 0);

        assertThat(view.teamMates()).extracting(PlayerItem::number).containsExactly(2);
        assertThat(view.opponents()).extracting(PlayerItem::team).containsExactly("Red");
    }

    @Test
    void placesAPlayerInTheMiddleOfItsVisibleParts() {
        view.setTime(1);
        view.see(players(player("Red", 1)), 0, 0);

        PlayerItem player = view.players().get(0);
        assertThat(player.position().distanceTo(new Vector3(2, 0, 0))).isLessThan(1e-9);
        assertThat(player.part(BodyPart.LEFT_FOOT).bearing()).isCloseTo(-45, within(1e-9));
        assertThat(player.part(BodyPart.HEAD).isKnown()).isFalse();
    }

    @Test
    void acceptsPlayersOfOldServersThatHaveOnlyOnePosition() {
        view.setTime(1);
        view.see(players(new SeenPlayer("Red", 1, List.of(), Optional.of(new PolarPosition(3, 5, 0)))), 0, 0);

        assertThat(view.players().get(0).distance()).isEqualTo(3);
    }

    @Test
    void forgetsPlayersAfterTenSeconds() {
        view.setTime(1);
        view.see(players(player("Red", 1)), 0, 0);
        view.setTime(10.9);
        int before = view.players().size();
        view.setTime(11.1);

        assertThat(before).isEqualTo(1);
        assertThat(view.players()).isEmpty();
    }

    @Test
    void leavesOutLinesWithAnglesThatAreNoNumbers() {
        SeenLine good = new SeenLine(new PolarPosition(1, 0, -20), new PolarPosition(2, 10, -10));
        SeenLine bad = new SeenLine(new PolarPosition(1, Double.NaN, 0), new PolarPosition(2, 10, -10));

        view.setTime(1);
        view.see(Vision.of(List.of(), Optional.empty(), List.of(), List.of(bad, good)), 0, 0);

        assertThat(view.lines()).containsExactly(new LineItem(new Direction(1, 0, -20), new Direction(2, 10, -10)));
    }

    @Test
    void forgetsEverythingAfterABeam() {
        view.setTime(1);
        view.see(ball(2, 0, 0), 0, 0);

        view.forget();

        assertThat(view.ball().isKnown()).isFalse();
    }

    @Test
    void seesLandmarksByTheirNames() {
        view.setTime(1);
        view.see(
                Vision.of(
                        List.of(new SeenLandmark(Landmark.FLAG_2_RIGHT, new PolarPosition(7, -30, -4))),
                        Optional.empty(),
                        List.of(),
                        List.of()),
                0,
                0);

        assertThat(view.landmark(Landmark.FLAG_2_RIGHT).isVisible()).isTrue();
        assertThat(view.landmark(Landmark.FLAG_2_RIGHT).bearing()).isEqualTo(-30);
    }

    private static Vision ball(double distance, double horizontal, double vertical) {
        PolarPosition position = new PolarPosition(distance, horizontal, vertical);
        return Vision.of(List.of(), Optional.of(position), List.of(), List.of());
    }

    private static Vision players(SeenPlayer... players) {
        return Vision.of(List.of(), Optional.empty(), List.of(players), List.of());
    }

    /** A robot whose feet are seen 45 degrees to the left and to the right. */
    private static SeenPlayer player(String team, int number) {
        double distance = 2 * Math.sqrt(2);
        return new SeenPlayer(
                team,
                number,
                List.of(
                        new SeenBodyPart(BodyPart.LEFT_FOOT, new PolarPosition(distance, -45, 0)),
                        new SeenBodyPart(BodyPart.RIGHT_FOOT, new PolarPosition(distance, 45, 0))),
                Optional.empty());
    }
}
