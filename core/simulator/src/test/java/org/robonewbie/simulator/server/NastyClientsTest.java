package org.robonewbie.simulator.server;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.lang.management.ManagementFactory;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.Socket;
import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import javax.management.JMException;
import javax.management.ObjectName;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.robonewbie.nao.Joint;
import org.robonewbie.protocol.tcp.TcpAgentLink;
import org.robonewbie.simulator.SimulationControl;
import org.robonewbie.simulator.cycle.WorldSettings;
import org.robonewbie.simulator.world.Robot;

/** Whatever a client does, its problem is named and a well-behaved agent is served on. */
@Timeout(120)
class NastyClientsTest {

    private static final String SCENE = "(scene rsg/agent/nao/nao.rsg)(syn)";

    private final RecordingConsole console = new RecordingConsole();
    private Simulator simulator;
    private TestAgent goodAgent;

    @BeforeEach
    void startGameWithGoodAgent() throws IOException {
        simulator = Simulator.start(
                SimulatorSettings.of(WorldSettings.beginner().withSynchronous(false))
                        .withAgentPort(0)
                        .withSpeed(SimulationControl.AS_FAST_AS_POSSIBLE),
                console);
        goodAgent = new TestAgent(TcpAgentLink.connect("127.0.0.1", simulator.agentPort()));
        goodAgent.joinRunningGame("Stars", 1);
    }

    @AfterEach
    void goodAgentIsStillServed() throws IOException {
        for (int i = 0; i < 5; i++) {
            assertThat(goodAgent.exchange("(syn)").seconds()).isPresent();
        }
        goodAgent.close();
        simulator.close();
    }

    @Test
    void lengthOfFourGigabytesEndsTheConnection() throws IOException {
        try (Socket socket = connect()) {
            socket.getOutputStream().write(new byte[] {-1, -1, -1, -1, '(', ')'});

            assertThat(socket.getInputStream().read()).isEqualTo(-1);
        }

        awaitSaid("4294967295 bytes");
    }

    @Test
    void messagesThatNeverEndTakeNoMoreThanTheirBytes() throws IOException {
        List<Socket> sockets = new ArrayList<>();
        byte[] endless = new byte[TcpServerLink.MAX_LENGTH - 1];
        long before = usedMebibytes();
        try {
            for (int i = 0; i < 100; i++) {
                Socket socket = connect();
                sockets.add(socket);
                socket.getOutputStream().write(prefix(TcpServerLink.MAX_LENGTH));
                socket.getOutputStream().write(endless);
            }
            for (int i = 0; i < 100; i++) {
                goodAgent.exchange("(syn)");
            }

            assertThat(usedMebibytes() - before).isLessThan(150);
        } finally {
            for (Socket socket : sockets) {
                socket.close();
            }
        }
    }

    @Test
    void messageLongerThanAnyRobotNeedsEndsTheConnection() throws IOException {
        try (Socket socket = connect()) {
            socket.getOutputStream().write(prefix(TcpServerLink.MAX_LENGTH + 1));

            assertThat(socket.getInputStream().read()).isEqualTo(-1);
        }

        awaitSaid((TcpServerLink.MAX_LENGTH + 1) + " bytes");
    }

    @Test
    void clientThatSaysNothingDisturbsNobody() throws IOException {
        try (Socket silent = connect()) {
            for (int i = 0; i < 200; i++) {
                goodAgent.exchange("(syn)");
            }

            assertThat(silent.getInputStream().available()).isZero();
        }
    }

    @Test
    void twelfthPlayerAndNumberTwelveAreNamed() throws IOException {
        List<TestAgent> agents = new ArrayList<>();
        try {
            for (int number = 2; number <= 11; number++) {
                TestAgent agent = agent();
                agents.add(agent);
                assertThat(agent.joinRunningGame("Stars", number)
                                .gameState()
                                .orElseThrow()
                                .number())
                        .hasValue(number);
            }
            TestAgent twelfth = agent();
            agents.add(twelfth);
            twelfth.exchange(SCENE);
            twelfth.send("(init (unum 0)(teamname Stars))");
            awaitSaid("already has all 11 players");
            twelfth.send("(init (unum 12)(teamname Moons))");
            awaitSaid("number 12 does not exist; choose 1 to 11");
        } finally {
            for (TestAgent agent : agents) {
                agent.close();
            }
        }
    }

    @Test
    void teamNameThatWouldBreakTheMessagesOfOthersIsRefused() throws IOException {
        try (TestAgent agent = agent()) {
            agent.exchange(SCENE);
            agent.send("(init (unum 1)(teamname \"My) (team\"))");

            awaitSaid("team name \"My) (team\" has spaces or parentheses");
        }
    }

    @Test
    void truncatedMessageIsForgottenWithItsClient() throws IOException {
        try (Socket socket = connect()) {
            socket.getOutputStream().write(prefix(100));
            socket.getOutputStream().write("(scene rsg".getBytes(StandardCharsets.US_ASCII));
        }
    }

    @Test
    void deepNestingIsSkipped() throws IOException {
        try (Socket socket = connect()) {
            send(socket, "(".repeat(100_000) + "x" + ")".repeat(100_000));
            send(socket, SCENE);

            assertThat(readFrame(socket)).startsWith("(time");
        }
    }

    @Test
    void strayParenthesesAndBinaryAreSkipped() throws IOException {
        try (Socket socket = connect()) {
            send(socket, ")))(((\u0000\u0001\u00ff");
            send(socket, "");
            send(socket, SCENE);

            assertThat(readFrame(socket)).startsWith("(time");
        }
    }

    @Test
    void hugeAndImpossibleNumbersDoNoHarm() throws IOException {
        try (TestAgent agent = new TestAgent(TcpAgentLink.connect("127.0.0.1", simulator.agentPort()))) {
            agent.joinRunningGame("Stars", 2);

            for (int i = 0; i < 20; i++) {
                agent.exchange("(he1 NaN)(he2 1e308)(lae1 -1e400)(rae1 inf)(beam nan 1e308 inf)(say )(syn)");
            }

            assertThat(agent.exchange("(syn)").jointAngles().degreesOr(Joint.NECK_YAW, 999))
                    .isBetween(-130.0, 130.0);
            // Who hangs up with unread messages may take away what it has sent as well.
            awaitSaid("NaN for hinge he1");
        }
    }

    @Test
    void unknownEffectorsAndRobotsAreNamed() throws IOException {
        try (Socket socket = connect()) {
            send(socket, "(scene rsg/agent/fridge.rsg)");
            send(socket, "(beam 0 0 0)");
            send(socket, "(fly 1)");
            awaitSaid("unknown robot \"rsg/agent/fridge.rsg \"");
            awaitSaid("although it has no robot");
            awaitSaid("Unknown effector \"fly\"");
        }
    }

    @Test
    void thirdTeamAndTakenNumberAreNamed() throws IOException {
        try (TestAgent moon = agent();
                TestAgent sun = agent();
                TestAgent twin = agent()) {
            moon.joinRunningGame("Moons", 1);

            assertThat(sun.joinInVain("Suns", 1).gameState().orElseThrow().number())
                    .isEmpty();
            assertThat(twin.joinInVain("Moons", 1).gameState().orElseThrow().number())
                    .isEmpty();
            awaitSaid("there is no room for team \"Suns\"");
            awaitSaid("number 1 of team \"Moons\" is taken");
        }
    }

    @Test
    void stormOfConnectionsIsSurvived() throws IOException {
        for (int i = 0; i < 10_000; i++) {
            Socket socket = connect();
            socket.setSoLinger(i % 2 == 0, 0);
            socket.close();
            if (i % 100 == 99) {
                goodAgent.exchange("(syn)");
            }
        }

        assertThat(console.sentences()).noneMatch(sentence -> sentence.contains("could not be accepted"));
    }

    @Test
    void bodiesOfRobotsThatHaveLeftAreForgotten() throws Exception {
        for (int i = 0; i < 300; i++) {
            try (TestAgent agent = agent()) {
                agent.exchange(SCENE);
            }
        }
        goodAgent.exchange("(syn)");

        assertThat(instancesOf(Robot.class)).isBetween(1L, 150L);
    }

    /** How many objects of a class are in use in this process, other tests' included. */
    private static long instancesOf(Class<?> type) throws JMException {
        String histogram = (String) ManagementFactory.getPlatformMBeanServer()
                .invoke(
                        new ObjectName("com.sun.management:type=DiagnosticCommand"),
                        "gcClassHistogram",
                        new Object[] {new String[] {}},
                        new String[] {String[].class.getName()});
        return histogram
                .lines()
                .map(line -> line.strip().split("\\s+", -1))
                .filter(words -> words.length >= 4 && words[3].equals(type.getName()))
                .mapToLong(words -> Long.parseLong(words[1]))
                .sum();
    }

    @Test
    void tooManyOpenConnectionsAreRefused() throws IOException {
        List<Socket> sockets = new ArrayList<>();
        try {
            for (int i = 0; i < 300; i++) {
                sockets.add(connect());
            }
            awaitSaid("256 agents are already connected");
        } finally {
            for (Socket socket : sockets) {
                socket.close();
            }
        }
    }

    @Test
    void robotsThatDoNotJoinAreLimited() throws IOException {
        List<TestAgent> agents = new ArrayList<>();
        try {
            for (int i = 0; i < 44; i++) {
                TestAgent agent = agent();
                agents.add(agent);
                agent.send(SCENE);
            }
            awaitSaid("there are already 44 robots");
        } finally {
            for (TestAgent agent : agents) {
                agent.close();
            }
        }
    }

    @Test
    void clientThatNeverReadsLosesMessagesOnly() throws IOException {
        try (Socket socket = new Socket()) {
            socket.setReceiveBufferSize(4096);
            socket.connect(new InetSocketAddress(InetAddress.getLoopbackAddress(), simulator.agentPort()));
            send(socket, SCENE);

            awaitSaid("does not read its messages fast enough");
        }
    }

    @Test
    void floodOfCommandsIsCut() throws IOException {
        try (TestAgent agent = agent()) {
            agent.joinRunningGame("Stars", 3);

            agent.exchange("(he1 0.1)".repeat(5000) + "(syn)");

            awaitSaid("more than 2000 commands in one cycle");
        }
    }

    @Test
    void vanishedClientLeavesThePitch() throws IOException {
        agent().joinRunningGame("Stars", 4).gameState();
        try (TestAgent agent = agent()) {
            agent.joinRunningGame("Stars", 5);
        }

        awaitSaid("player 5 of Stars");
        try (TestAgent agent = agent()) {
            assertThat(agent.joinRunningGame("Stars", 5)
                            .gameState()
                            .orElseThrow()
                            .number())
                    .hasValue(5);
        }
    }

    private TestAgent agent() throws IOException {
        return new TestAgent(TcpAgentLink.connect("127.0.0.1", simulator.agentPort()));
    }

    private Socket connect() throws IOException {
        return new Socket(InetAddress.getLoopbackAddress(), simulator.agentPort());
    }

    private static void send(Socket socket, String text) throws IOException {
        byte[] bytes = text.getBytes(StandardCharsets.ISO_8859_1);
        socket.getOutputStream().write(prefix(bytes.length));
        socket.getOutputStream().write(bytes);
    }

    private static long usedMebibytes() {
        System.gc();
        return (Runtime.getRuntime().totalMemory() - Runtime.getRuntime().freeMemory()) >> 20;
    }

    private static byte[] prefix(int length) {
        return ByteBuffer.allocate(4).putInt(length).array();
    }

    private static String readFrame(Socket socket) throws IOException {
        byte[] prefix = socket.getInputStream().readNBytes(4);
        byte[] bytes =
                socket.getInputStream().readNBytes(ByteBuffer.wrap(prefix).getInt());
        return new String(bytes, StandardCharsets.US_ASCII);
    }

    private void assertSaid(String part) {
        assertThat(console.sentences()).anyMatch(sentence -> sentence.contains(part));
    }

    /** Lets the game go on until the console has told something. */
    private void awaitSaid(String part) throws IOException {
        long end = System.nanoTime() + Duration.ofSeconds(100).toNanos();
        while (console.sentences().stream().noneMatch(sentence -> sentence.contains(part)) && System.nanoTime() < end) {
            goodAgent.exchange("(syn)");
        }
        assertSaid(part);
    }
}
