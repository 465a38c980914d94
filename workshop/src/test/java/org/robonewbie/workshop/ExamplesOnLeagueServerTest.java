package org.robonewbie.workshop;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.util.List;
import java.util.Objects;
import java.util.Optional;
import java.util.stream.Stream;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.robonewbie.agent.Agent;
import org.robonewbie.agent.ExamplesOnT1;
import org.robonewbie.nao.PlayMode;
import org.robonewbie.nao.TeamSide;
import org.robonewbie.nao.Vector3;
import org.robonewbie.nao.geometry.Pose2d;
import org.robonewbie.nao.geometry.Translation2d;
import org.robonewbie.nao.kinematics.BodyState;
import org.robonewbie.nao.kinematics.Pose;
import org.robonewbie.protocol.frame.AgentLink;
import org.robonewbie.protocol.frame.MessageBuffer;
import org.robonewbie.protocol.order.Order;
import org.robonewbie.simulator.SimulationObserver;
import org.robonewbie.simulator.WorldSnapshot;
import org.robonewbie.studio.monitor.MonitoredSimulation;
import org.robonewbie.workshop.load.ExampleLoad;

/** Plays the examples as a T1 on a real RCSSServerMJ, as the table of docs/from-nao-to-t1.md promises. */
@Tag("slow")
@Timeout(300)
class ExamplesOnLeagueServerTest {

    private static final Vector3 FORWARD = new Vector3(1, 0, 0);

    static Stream<String> examples() {
        return ExampleLoad.examples().keySet().stream().filter(name -> !name.equals("Agent_KeyframeDeveloper"));
    }

    @ParameterizedTest
    @MethodSource("examples")
    void exampleDoesWhatTheTableSays(String name) throws IOException {
        Class<? extends Agent> type =
                Objects.requireNonNull(ExampleLoad.examples().get(name));
        String promised = ExamplesOnT1.missing(ExampleLoad.agents(type).get(0));

        try (RunningLeagueServer server = RunningLeagueServer.orSkip();
                AgentLink link = new BallMover(server.connect(), server.match())) {
            List<String> reports = ExamplesOnT1.reports(ExampleLoad.agents(type).get(0), link);

            assertThat(ExamplesOnT1.missing(reports)).as("%s", reports).isEqualTo(promised);
            assertThat(reports).noneMatch(report -> report.contains("has fallen"));
        }
    }

    /** Connection that ends after some time, and until then moves the ball to where the script of {@link ExamplesOnT1} has it. */
    private static final class BallMover implements AgentLink, SimulationObserver {

        private final AgentLink link;
        private final MonitoredSimulation match;
        private volatile Optional<WorldSnapshot> seen = Optional.empty();
        private int cycle;
        private Optional<ExamplesOnT1.Ball> ball = Optional.empty();

        BallMover(AgentLink link, MonitoredSimulation match) {
            this.link = link;
            this.match = match;
            match.addObserver(this);
        }

        @Override
        public void cycleEnded(WorldSnapshot snapshot) {
            seen = Optional.of(snapshot);
        }

        @Override
        public boolean receive(MessageBuffer message) throws IOException {
            seen.filter(world -> !world.robots().isEmpty()).ifPresent(this::referee);
            return ++cycle <= ExamplesOnT1.CYCLES && link.receive(message);
        }

        private void referee(WorldSnapshot world) {
            if (cycle == 120) {
                match.order(new Order.KickOff(TeamSide.LEFT));
            }
            if (cycle > 120 && world.playMode() == PlayMode.KICK_OFF_LEFT) {
                match.order(new Order.DropBall());
            }
            ExamplesOnT1.Ball next = ExamplesOnT1.ball(cycle);
            if (!ball.equals(Optional.of(next))) {
                ball = Optional.of(next);
                Pose torso = world.robots().get(0).state().torso();
                double heading = BodyState.headingDegrees(torso.rotation().apply(FORWARD));
                Translation2d place = new Translation2d(next.ahead(), next.left())
                        .onMap(new Pose2d(torso.position().x(), torso.position().y(), heading));
                Translation2d velocity = Translation2d.polar(heading, -next.approach());
                match.order(new Order.MoveBall(
                        new Vector3(place.x(), place.y(), 0.11), new Vector3(velocity.x(), velocity.y(), 0)));
            }
        }

        @Override
        public void send(MessageBuffer message) throws IOException {
            link.send(message);
        }

        @Override
        public void close() {
            link.close();
        }
    }
}
