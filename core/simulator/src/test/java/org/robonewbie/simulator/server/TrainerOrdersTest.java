package org.robonewbie.simulator.server;

import static org.assertj.core.api.Assertions.assertThat;
import static org.robonewbie.simulator.server.MonitoredSimulator.LEFT_1;
import static org.robonewbie.simulator.server.MonitoredSimulator.LEFT_2;

import java.io.IOException;
import java.util.Optional;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.robonewbie.nao.PlayMode;
import org.robonewbie.nao.TeamSide;
import org.robonewbie.nao.Vector3;
import org.robonewbie.protocol.monitor.MeshNode;
import org.robonewbie.protocol.monitor.MonitoredWorld;
import org.robonewbie.protocol.monitor.SceneNode;
import org.robonewbie.protocol.monitor.TransformNode;
import org.robonewbie.protocol.order.Order;
import org.robonewbie.protocol.order.PlayerNumber;
import org.robonewbie.protocol.perceptor.PerceptorMessage;

@Timeout(120)
class TrainerOrdersTest {

    @SuppressWarnings("NullAway.Init")
    private MonitoredSimulator match;

    @BeforeEach
    void start() throws IOException {
        match = new MonitoredSimulator();
    }

    @AfterEach
    void end() throws IOException {
        match.close();
    }

    @Test
    void playModeIsSet() throws IOException {
        match.order(new Order.ChangePlayMode(PlayMode.CORNER_KICK_RIGHT));

        match.await(seen -> isMode(seen, PlayMode.CORNER_KICK_RIGHT));
    }

    @Test
    void simulatorWithoutTrainersShowsEverythingAndObeysNobody() throws IOException {
        try (MonitoredSimulator closed = new MonitoredSimulator(false)) {
            closed.join("Stars", 1);
            closed.order(
                    new Order.SetScore(3, 0),
                    new Order.KillRobot(Optional.of(LEFT_1)),
                    new Order.EndSimulation(),
                    new Order.RequestFullState());
            closed.awaitFullMessage();
            closed.receive();

            assertThat(closed.world().robots()).hasSize(1);
            assertThat(closed.world().gameState().scoreLeft()).isZero();
            assertThat(closed.told())
                    .contains("A trainer tried to change the world, which this simulator does not allow. Start the"
                            + " simulator without --no-trainers to allow this.");
        }
    }

    @Test
    void namedTeamKicksOff() throws IOException {
        match.order(new Order.KickOff(Optional.of(TeamSide.RIGHT)));

        match.await(seen -> isMode(seen, PlayMode.KICK_OFF_RIGHT));
    }

    @Test
    void leftTeamKicksOffFirstByTheRules() throws IOException {
        match.order(new Order.KickOff(Optional.empty()));

        match.await(seen -> isMode(seen, PlayMode.KICK_OFF_LEFT));
    }

    @Test
    void ballIsMovedPushedAndDropped() throws IOException {
        match.order(
                new Order.ChangePlayMode(PlayMode.PLAY_ON),
                new Order.MoveBall(Optional.of(new Vector3(3, 2, 0.042)), Optional.empty()));
        match.await(seen -> ball(seen).distanceTo(new Vector3(3, 2, 0.042)) < 0.05);

        match.order(new Order.MoveBall(Optional.empty(), Optional.of(new Vector3(0, -2, 0))));
        match.await(seen -> ball(seen).y() < 1);

        match.order(new Order.ChangePlayMode(PlayMode.KICK_IN_LEFT), new Order.DropBall());
        match.await(seen -> isMode(seen, PlayMode.PLAY_ON));
    }

    @Test
    void robotIsMovedWithoutTurning() throws IOException {
        match.join("us", 1);
        match.order(new Order.ChangePlayMode(PlayMode.PLAY_ON));
        Vector3 forward = match.torso(LEFT_1).axisY();

        match.order(new Order.MoveRobot(LEFT_1, new Vector3(-4, 3, 0.5)));

        match.await(seen -> isNear(LEFT_1, -4, 3));
        assertThat(match.torso(LEFT_1).axisY().distanceTo(forward)).isLessThan(0.2);
    }

    @Test
    void robotIsMovedUprightAndTurned() throws IOException {
        match.join("us", 1);
        match.order(
                new Order.ChangePlayMode(PlayMode.PLAY_ON),
                new Order.MoveAndTurnRobot(LEFT_1, new Vector3(2, -3, 0.5), 90));

        match.await(seen -> isNear(LEFT_1, 2, -3));
        assertThat(match.torso(LEFT_1).axisY().x()).isLessThan(-0.95);
        assertThat(match.torso(LEFT_1).axisZ().z()).isGreaterThan(0.9);
    }

    @Test
    void selectionGoesFromRobotToRobotAndAway() throws IOException {
        match.join("us", 1);
        match.join("us", 2);

        match.order(new Order.SelectRobot(LEFT_2));
        match.await(seen -> !isSelected(seen, 0) && isSelected(seen, 1));
        match.order(new Order.SelectNextRobot());
        match.await(seen -> isSelected(seen, 0) && !isSelected(seen, 1));
        match.order(new Order.SelectNoRobot());
        match.await(seen -> !isSelected(seen, 0) && !isSelected(seen, 1));
    }

    @Test
    void robotIsPutBesideThePitchOppositeToTheBall() throws IOException {
        match.join("us", 2);
        match.order(
                new Order.ChangePlayMode(PlayMode.PLAY_ON),
                new Order.MoveBall(Optional.of(new Vector3(0, -5, 0.042)), Optional.empty()),
                new Order.RepositionRobot(Optional.of(LEFT_2)));

        match.await(seen -> isNear(LEFT_2, -3, 10.5));
    }

    @Test
    void selectedRobotIsMovedBackAndPutBesideThePitch() throws IOException {
        match.join("us", 2);
        match.order(
                new Order.ChangePlayMode(PlayMode.PLAY_ON),
                new Order.SelectRobot(LEFT_2),
                new Order.MoveRobot(LEFT_2, new Vector3(0, 4, 0.5)));
        match.await(seen -> isNear(LEFT_2, 0, 4));

        match.order(new Order.RepelSelectedRobot());
        match.await(seen -> isNear(LEFT_2, -2.5, 4));
        match.order(new Order.RepositionRobot(Optional.empty()));
        match.await(seen -> Math.abs(match.torso(LEFT_2).position().y()) > 10);
    }

    @Test
    void killedRobotLeavesThePitchWhileItsAgentStaysConnected() throws IOException {
        TestAgent agent = match.join("us", 2);

        match.order(new Order.KillRobot(Optional.of(LEFT_2)));
        match.await(seen -> seen.robots().isEmpty());
        PerceptorMessage message = rejoin(agent);

        assertThat(message.gameState().orElseThrow().number()).hasValue(5);
        match.await(seen -> seen.robots().size() == 1);
    }

    @Test
    void timeAndScoreAreSet() throws IOException {
        match.order(new Order.ChangePlayMode(PlayMode.PLAY_ON), new Order.SetTime(100), new Order.SetScore(4, 2));

        match.await(seen -> seen.gameState().timeSeconds() >= 100);
        assertThat(match.world().gameState().timeSeconds()).isLessThan(150);
        assertThat(match.world().gameState().scoreLeft()).isEqualTo(4);
        assertThat(match.world().gameState().scoreRight()).isEqualTo(2);
    }

    @Test
    void fullStateIsSentOnRequest() throws IOException {
        match.awaitFullMessage();

        match.order(new Order.RequestFullState());

        assertThat(match.awaitFullMessage()).startsWith("((FieldLength 30)");
    }

    @Test
    void simulationEndsOnRequest() throws Exception {
        match.order(new Order.EndSimulation());

        match.simulator().awaitEnd();
        while (match.monitor().receive()) {
            // messages that were under way
        }
    }

    @Test
    void ordersForNobodyDoNothing() throws IOException {
        PlayerNumber nobody = new PlayerNumber(TeamSide.RIGHT, 11);

        match.order(
                new Order.MoveRobot(nobody, Vector3.ZERO),
                new Order.KillRobot(Optional.of(nobody)),
                new Order.KillRobot(Optional.empty()),
                new Order.RepositionRobot(Optional.empty()),
                new Order.RepelSelectedRobot(),
                new Order.SelectNextRobot(),
                new Order.SetScore(1, 0));

        match.await(seen -> seen.gameState().scoreLeft() == 1);
        assertThat(match.world().robots()).isEmpty();
    }

    @Test
    void agentMayBeamAgainAndItsTimeGoesOnAfterATrainerStopsTheGame() throws IOException {
        TestAgent agent = match.join("us", 1);
        match.order(new Order.ChangePlayMode(PlayMode.PLAY_ON));
        match.await(seen -> seen.gameState().timeSeconds() > 0.5);

        match.order(new Order.ChangePlayMode(PlayMode.BEFORE_KICK_OFF));
        match.await(seen -> isMode(seen, PlayMode.BEFORE_KICK_OFF));
        double stopped = match.world().gameState().timeSeconds();
        agent.send("(beam -7 -2 0)");

        match.await(seen -> isNear(LEFT_1, -7, -2));
        double before = agent.receive().seconds().orElseThrow();
        assertThat(agent.receive().seconds().orElseThrow()).isGreaterThan(before);
        assertThat(match.world().gameState().timeSeconds()).isEqualTo(stopped);
    }

    private static PerceptorMessage rejoin(TestAgent agent) throws IOException {
        agent.send("(scene rsg/agent/nao/nao.rsg)");
        agent.send("(init (unum 5)(teamname us))");
        PerceptorMessage message = agent.receive();
        while (message.gameState().orElseThrow().number().orElse(0) != 5) {
            agent.send("(init (unum 5)(teamname us))");
            message = agent.receive();
        }
        return message;
    }

    private boolean isNear(PlayerNumber player, double x, double y) {
        Vector3 place = match.torso(player).position();
        return Math.hypot(place.x() - x, place.y() - y) < 0.3;
    }

    private static boolean isMode(MonitoredWorld seen, PlayMode mode) {
        return seen.gameState().playMode().equals(Optional.of(mode));
    }

    private static Vector3 ball(MonitoredWorld seen) {
        return seen.ball().orElseThrow().position();
    }

    private static boolean isSelected(MonitoredWorld seen, int index) {
        return hasVisibleMarker(seen.scene().get(36 + index));
    }

    private static boolean hasVisibleMarker(SceneNode node) {
        if (node instanceof MeshNode mesh) {
            return mesh.form().name().equals("StdUnitCylinder") && mesh.isVisible();
        }
        return node instanceof TransformNode transform
                && transform.children().stream().anyMatch(TrainerOrdersTest::hasVisibleMarker);
    }
}
