package org.robonewbie.simulator.server;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.io.IOException;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.Socket;
import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import org.junit.jupiter.api.AutoClose;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.robonewbie.nao.PlayMode;
import org.robonewbie.nao.Vector3;
import org.robonewbie.protocol.perceptor.PerceptorMessage;

/** What the agents of UT Austin Villa need beyond what all agents need, above all those that learn and order as trainers. */
@Timeout(120)
class AustinVillaExpectationsTest {

    @AutoClose
    private final LeagueServer server = new LeagueServer();

    private final TestAgent agent = server.join("Stars", 1);

    AustinVillaExpectationsTest() throws IOException {}

    @Test
    void trainerThatNeverReadsIsObeyedForLongAndStallsNobody() throws IOException {
        try (Socket trainer = deafTrainer()) {
            order(trainer, "(playMode PlayOn)");
            awaitMode(PlayMode.PLAY_ON);

            LeagueServer.cycles(agent, 3000);
            order(trainer, "(ball (pos 3 -9 0.042) (vel 0 0 0))");

            awaitBall(3, -9);
            order(trainer, "(playMode BeforeKickOff)");
            awaitMode(PlayMode.BEFORE_KICK_OFF);
        }
    }

    @Test
    void severalOrdersInOneMessageAreCarriedOut() throws IOException {
        try (Socket trainer = deafTrainer()) {
            order(trainer, "(playMode PlayOn) (ball (pos 0 -9 0) (vel 0 0 0))");

            awaitMode(PlayMode.PLAY_ON);
            awaitBall(0, -9);
        }
    }

    @Test
    void agentMayBeamAgainAndItsTimeGoesOnAfterTheTrainerHasStoppedTheGame() throws IOException {
        try (Socket trainer = deafTrainer()) {
            order(trainer, "(playMode PlayOn)");
            awaitMode(PlayMode.PLAY_ON);
            order(trainer, "(playMode BeforeKickOff)");
            PerceptorMessage before = awaitMode(PlayMode.BEFORE_KICK_OFF);

            LeagueServer.cyclesOfAll(3, "(beam -7 -2 0)(syn)", agent);
            PerceptorMessage after = agent.exchange("(syn)");

            assertThat(server.torso(0, 0)).isCloseTo(-7, within(0.1));
            assertThat(server.torso(0, 1)).isCloseTo(-2, within(0.1));
            assertThat(after.gameState().orElseThrow().playSeconds())
                    .isEqualTo(before.gameState().orElseThrow().playSeconds());
            assertThat(after.seconds().orElseThrow())
                    .isGreaterThan(before.seconds().orElseThrow());
        }
    }

    @Test
    void accelerationOfAStandingRobotStaysBelowTwenty() throws IOException {
        agent.exchange("(beam -5 0 0)(syn)");
        LeagueServer.cycles(agent, 50);

        for (int i = 0; i < 100; i++) {
            Vector3 acceleration = agent.exchange("(syn)").accelerometer().orElseThrow();
            assertThat(Math.max(Math.abs(acceleration.x()), Math.abs(acceleration.y())))
                    .isLessThan(1);
            assertThat(acceleration.z()).isCloseTo(9.81, within(1.0));
        }
    }

    private Socket deafTrainer() throws IOException {
        Socket trainer = new Socket();
        trainer.setReceiveBufferSize(4096);
        trainer.connect(new InetSocketAddress(
                InetAddress.getLoopbackAddress(), server.simulator.monitorPort().orElseThrow()));
        return trainer;
    }

    private static void order(Socket trainer, String text) throws IOException {
        byte[] bytes = text.getBytes(StandardCharsets.US_ASCII);
        trainer.getOutputStream()
                .write(ByteBuffer.allocate(4 + bytes.length)
                        .putInt(bytes.length)
                        .put(bytes)
                        .array());
    }

    private PerceptorMessage awaitMode(PlayMode mode) throws IOException {
        PerceptorMessage message = agent.exchange("(syn)");
        while (message.gameState().orElseThrow().playMode().orElseThrow() != mode) {
            message = agent.exchange("(syn)");
        }
        return message;
    }

    private void awaitBall(double x, double y) throws IOException {
        do {
            agent.exchange("(syn)");
        } while (server.watcher.latest().ballPosition().distanceTo(new Vector3(x, y, 0.042)) > 0.1);
    }
}
