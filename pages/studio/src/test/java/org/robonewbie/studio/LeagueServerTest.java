package org.robonewbie.studio;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.io.IOException;
import java.net.ServerSocket;
import java.util.List;
import java.util.Optional;
import java.util.function.Predicate;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.robonewbie.nao.PlayMode;
import org.robonewbie.nao.TeamSide;
import org.robonewbie.nao.Vector3;
import org.robonewbie.protocol.frame.AgentLink;
import org.robonewbie.protocol.frame.MessageBuffer;
import org.robonewbie.protocol.order.Order;
import org.robonewbie.protocol.order.PlayerNumber;
import org.robonewbie.protocol.tcp.TcpAgentLink;
import org.robonewbie.simulator.RobotSnapshot;
import org.robonewbie.simulator.SimulationObserver;
import org.robonewbie.simulator.WorldSnapshot;
import org.robonewbie.studio.league.LeagueServer;
import org.robonewbie.studio.monitor.MonitoredSimulation;

/** Watches a T1 on a real RCSSServerMJ. */
@Tag("slow")
@Timeout(180)
class LeagueServerTest {

    private static final Tool SERVER = new Tool("RCSSServerMJ", List.of("rcssservermj", "rcssservermj.exe"));
    private static final String HOST = "127.0.0.1";
    private static final Pattern POSITION = Pattern.compile("torso_pos\\) \\(p (\\S+) (\\S+) ([^)]+)\\)");
    private static final String STANCE = Stream.of("l", "r")
            .map(side -> Stream.of("1 -20", "2 0", "3 0", "4 40", "5 -20", "6 0")
                    .map(target -> "(" + side + "le" + target + " 0 300 5 0)")
                    .collect(Collectors.joining()))
            .collect(Collectors.joining("", "", "(te1 0 0 300 5 0)"));
    private static final Vector3 PLACE = new Vector3(-8, 3, 0.68);
    private static final int CYCLES_TO_SETTLE = 100;

    private final MessageBuffer message = new MessageBuffer();
    private volatile Optional<WorldSnapshot> seen = Optional.empty();

    @Test
    @SuppressWarnings("try") // the server only has to run
    void robotIsSeenWhereItsServerHasIt() throws Exception {
        SERVER.orSkip();
        int port = freePort();
        int monitorPort = freePort();
        try (LeagueServer server = LeagueServer.start(port, monitorPort);
                MonitoredSimulation match = MonitoredSimulation.connect(HOST, monitorPort);
                AgentLink agent = TcpAgentLink.connect(HOST, port)) {
            match.addObserver(new SimulationObserver() {
                @Override
                public void cycleEnded(WorldSnapshot snapshot) {
                    seen = Optional.of(snapshot);
                }
            });
            send("(init T1 Blue 2)", agent);
            playUntil(world -> !world.robots().isEmpty(), agent);

            match.order(new Order.KickOff(TeamSide.LEFT));
            playUntil(world -> world.playMode() == PlayMode.KICK_OFF_LEFT, agent);
            match.order(new Order.PlaceRobot(new PlayerNumber(TeamSide.LEFT, 2), PLACE, 90));
            playUntil(world -> torso(world).minus(PLACE).length() < 0.2, agent);
            for (int i = 0; i < CYCLES_TO_SETTLE; i++) {
                play(agent);
            }

            Vector3 truth = play(agent);
            RobotSnapshot robot = seen.orElseThrow().robots().get(0);
            assertThat(robot.state().model().name()).isEqualTo("T1");
            assertThat(robot.team()).isEqualTo("Blue");
            assertThat(robot.state().torso().position().minus(truth).length()).isCloseTo(0, within(0.01));
        }
    }

    /** Answers the server until the watched world is as wanted. */
    private void playUntil(Predicate<WorldSnapshot> wanted, AgentLink agent) throws IOException {
        while (seen.filter(wanted).isEmpty()) {
            play(agent);
        }
    }

    /** Answers a message of the server, and returns where it says that the torso is. */
    private Vector3 play(AgentLink agent) throws IOException {
        assertThat(agent.receive(message)).isTrue();
        Matcher position = POSITION.matcher(message.toString());
        assertThat(position.find()).isTrue();
        send(STANCE, agent);
        return new Vector3(
                Double.parseDouble(position.group(1)),
                Double.parseDouble(position.group(2)),
                Double.parseDouble(position.group(3)));
    }

    private static void send(String text, AgentLink agent) throws IOException {
        MessageBuffer answer = new MessageBuffer();
        answer.append(text);
        agent.send(answer);
    }

    private static Vector3 torso(WorldSnapshot world) {
        return world.robots().get(0).state().torso().position();
    }

    private static int freePort() throws IOException {
        try (ServerSocket port = new ServerSocket(0)) {
            return port.getLocalPort();
        }
    }
}
