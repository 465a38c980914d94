package org.robonewbie.simulator.server;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.net.InetAddress;
import java.net.Socket;
import java.net.StandardProtocolFamily;
import java.net.UnixDomainSocketAddress;
import java.nio.ByteBuffer;
import java.nio.channels.SocketChannel;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.LinkedBlockingQueue;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.condition.EnabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.io.TempDir;
import org.robonewbie.protocol.tcp.TcpAgentLink;
import org.robonewbie.simulator.SimulationControl;
import org.robonewbie.simulator.WorldSnapshot;
import org.robonewbie.simulator.cycle.WorldSettings;

/** Whoever comes through the door of a team plays for this team, whatever it says. */
@Timeout(60)
class TeamEndpointTest {

    private static final TeamEndpoint RED = new TeamEndpoint("Red", 1, Optional.empty(), guest -> true);

    @TempDir
    Path folder = Path.of("");

    @Test
    void robotBelongsToTheTeamOfItsDoorWhateverItSays() throws Exception {
        try (Simulator simulator = start(RED, new TeamEndpoint("Blue", 1, Optional.empty(), guest -> true));
                TestAgent red = agent(simulator, "Red");
                TestAgent impostor = agent(simulator, "Blue")) {
            red.joinRunningGame("Red", 1);
            impostor.joinRunningGame("Red", 5);

            WorldSnapshot world = next(simulator);

            assertThat(world.robots())
                    .extracting(robot -> robot.team() + " " + robot.number())
                    .containsExactlyInAnyOrder("Red 1", "Blue 5");
            assertThat(simulator.agentPort()).isZero();
            assertThat(simulator.control().agentPort()).isEmpty();
        }
    }

    @Test
    void crowdFromOneTeamIsNotTakenForTheOtherThatIsAwaited() throws Exception {
        List<TeamEndpoint> doors = List.of(RED, new TeamEndpoint("Blue", 1, Optional.empty(), guest -> true));
        SimulatorSettings waiting = SimulatorSettings.of(WorldSettings.beginner())
                .withAgents(agents(2, doors))
                .withSpeed(SimulationControl.AS_FAST_AS_POSSIBLE);

        try (Simulator simulator = Simulator.start(waiting, sentence -> {});
                TestAgent first = agent(simulator, "Red");
                TestAgent second = agent(simulator, "Red");
                TestAgent blue = agent(simulator, "Blue")) {
            BlockingQueue<WorldSnapshot> worlds = new LinkedBlockingQueue<>();
            simulator.control().addObserver(worlds::add);
            first.send("(syn)");
            second.send("(syn)");
            assertThat(worlds.take().cycle()).isZero(); // the world stands still, and says so
            assertThat(worlds.take().cycle()).isZero();

            blue.send("(scene rsg/agent/nao/nao.rsg)(syn)");

            assertThat(blue.receive().seconds()).isPresent();
        }
    }

    @Test
    void robotWithoutTeamCountsForItsDoor() throws Exception {
        try (Simulator simulator = start(RED);
                TestAgent silent = agent(simulator, "Red")) {
            silent.exchange("(scene rsg/agent/nao/nao.rsg)");
            BlockingQueue<Integer> counts = new LinkedBlockingQueue<>();
            simulator.control().addObserver(world -> counts.add(simulator.robotsOf("Red")));

            assertThat(counts.take()).isOne();
        }
    }

    @Test
    void strangerIsSentAwayAtTheDoor() throws Exception {
        TeamEndpoint closed = new TeamEndpoint("Red", 1, Optional.empty(), guest -> false);

        try (Simulator simulator = start(closed);
                Socket stranger = new Socket(InetAddress.getLoopbackAddress(), simulator.agentPort("Red"))) {
            assertThatThrownBy(() -> {
                        stranger.getOutputStream().write(0);
                        if (stranger.getInputStream().read() < 0) {
                            throw new IOException("closed");
                        }
                    })
                    .isInstanceOf(IOException.class);
            assertThat(simulator.connectedAgents()).isZero();
        }
    }

    @Test
    @EnabledOnOs({OS.LINUX, OS.MAC})
    void doorMayBeAFile() throws Exception {
        Path file = folder.resolve("red");

        try (Simulator simulator = start(new TeamEndpoint("Red", 1, Optional.of(file), guest -> false));
                SocketChannel agent = SocketChannel.open(StandardProtocolFamily.UNIX)) {
            agent.connect(UnixDomainSocketAddress.of(file));
            byte[] text = "(scene rsg/agent/nao/nao.rsg)".getBytes(StandardCharsets.US_ASCII);
            agent.write(ByteBuffer.allocate(4 + text.length)
                    .putInt(text.length)
                    .put(text)
                    .flip());
            ByteBuffer answer = ByteBuffer.allocate(100);
            while (answer.hasRemaining()) {
                agent.read(answer);
            }

            assertThat(new String(answer.array(), 4, 96, StandardCharsets.US_ASCII))
                    .startsWith("(time (now ");
            assertThat(simulator.agentPort("Red")).isZero();
        }
    }

    private static Simulator start(TeamEndpoint... doors) throws IOException {
        return Simulator.start(
                SimulatorSettings.of(WorldSettings.beginner().withSynchronous(false))
                        .withAgents(agents(0, List.of(doors)))
                        .withSpeed(5),
                sentence -> {});
    }

    private static SimulatorSettings.Agents agents(int awaited, List<TeamEndpoint> doors) {
        return new SimulatorSettings.Agents(SimulatorSettings.LOCALHOST, 0, doors, awaited, 60);
    }

    private static TestAgent agent(Simulator simulator, String team) throws IOException {
        return new TestAgent(TcpAgentLink.connect("127.0.0.1", simulator.agentPort(team)));
    }

    private static WorldSnapshot next(Simulator simulator) throws InterruptedException {
        BlockingQueue<WorldSnapshot> worlds = new LinkedBlockingQueue<>();
        simulator.control().addObserver(worlds::add);
        return worlds.take();
    }
}
