package org.robonewbie.agent;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.io.OutputStream;
import java.net.InetAddress;
import java.net.ServerSocket;
import java.net.Socket;
import java.util.ArrayList;
import java.util.List;
import java.util.function.Predicate;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.robonewbie.nao.PlayMode;
import org.robonewbie.nao.TeamSide;
import org.robonewbie.protocol.frame.MessageBuffer;
import org.robonewbie.protocol.perceptor.PerceptorMessage;
import org.robonewbie.protocol.tcp.FrameOutput;

class StartDialogueTest {

    @Test
    void createsTheRobotJoinsBeamsAndAnswersEachMessageOnce() throws Exception {
        try (ScriptedServer server = new ScriptedServer(script(2, 30))) {
            Nao nao = Nao.connect(options(server).withTeam("Blue").withNumber(4).withPose(-1, 0.5, 90));
            boolean running = nao.sense();
            nao.act();
            nao.close();
            server.await();

            assertThat(running).isTrue();
            assertThat(nao.getTeamSide()).isEqualTo(TeamSide.RIGHT);
            assertThat(server.received().subList(0, 5))
                    .containsExactly(
                            "(scene rsg/agent/nao/nao.rsg)(syn)",
                            "(init (unum 4)(teamname Blue))(syn)",
                            "(syn)",
                            "(beam -1 0.5 90)(syn)",
                            "(syn)");
            assertThat(server.received()).allMatch(message -> message.endsWith("(syn)"));
        }
    }

    @Test
    void waitsUntilItHasItsNumberHoweverLongThatTakes() throws Exception {
        try (ScriptedServer server = new ScriptedServer(script(20, 60))) {
            Nao nao = Nao.connect(options(server));
            nao.close();

            assertThat(nao.getNumber()).isEqualTo(4);
            assertThat(server.received()).contains("(beam -1 -2 0)(syn)");
        }
    }

    @Test
    void buildsOtherRobotTypes() throws Exception {
        try (ScriptedServer server = new ScriptedServer(script(2, 30))) {
            Nao.connect(options(server).with("type", "3")).close();

            assertThat(server.received().get(0)).isEqualTo("(scene rsg/agent/nao/nao_hetero.rsg 3)(syn)");
        }
    }

    @Test
    void saysWhatToDoWhenTheNumberIsRefused() throws Exception {
        try (ScriptedServer server = new ScriptedServer(script(Integer.MAX_VALUE, 200))) {
            Options options = options(server).withTeam("Blue").withNumber(4);

            assertThatThrownBy(() -> Nao.connect(options))
                    .isInstanceOf(StartUpException.class)
                    .hasMessage("The simulator refused number 4 of team Blue. Choose a free number (--number 0"
                            + " takes any), or a team that is already playing (--team). A league team has at most 7"
                            + " robots of one type: choose another type (--type) for the others.");
        }
    }

    @Test
    void saysThatTheServerHasClosedDuringTheStart() throws Exception {
        try (ScriptedServer server = new ScriptedServer(script(2, 5))) {
            Options options = options(server);

            assertThatThrownBy(() -> Nao.connect(options))
                    .isInstanceOf(StartUpException.class)
                    .hasMessageContaining("The simulator did not accept the robot");
        }
    }

    @Test
    void saysWhichServerEndsAtTheFirstMessage() throws Exception {
        try (ScriptedServer server = new ScriptedServer(List.of())) {
            Options options = options(server);

            assertThatThrownBy(() -> Nao.connect(options))
                    .isInstanceOf(StartUpException.class)
                    .hasMessageContaining("RCSSServerMJ")
                    .hasMessageContaining("robonewbie.league bridge");
        }
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            value = {
                "NAO | ((RSMP 1 0)((gt 1 0)0.04)) | this is the monitor port of RCSSServerMJ",
                "NAO | ((FieldLength 30)(FieldWidth 20)) | this is the monitor port of a SimSpark server",
                "T1 | ((RSMP 1 0)((gt 1 0)0.04)) | RCSSServerMJ, which is for watching: join at its agent port, which is"
                        + " usually 60000 (--port 60000).",
                "T1 | ((FieldLength 30)(FieldWidth 20)) | this is the monitor port of a SimSpark server"
            })
    void saysWhoseMonitorPortItIs(String robot, String message, String reason) throws Exception {
        try (ServerSocket socket = new ServerSocket(0, 1, InetAddress.getLoopbackAddress())) {
            Thread server = new Thread(() -> send(socket, message), "monitor port");
            server.start();
            Options options = Options.none()
                    .with("host", "127.0.0.1")
                    .with("port", Integer.toString(socket.getLocalPort()))
                    .with("robot", robot);

            assertThatThrownBy(() -> Nao.connect(options))
                    .isInstanceOf(StartUpException.class)
                    .hasMessageContaining(reason);
        }
    }

    private static void send(ServerSocket socket, String message) {
        try (Socket client = socket.accept()) {
            MessageBuffer buffer = new MessageBuffer();
            buffer.append(message);
            new FrameOutput(client.getOutputStream()).write(buffer);
            client.getInputStream().transferTo(OutputStream.nullOutputStream());
        } catch (IOException left) {
            // The client has left.
        }
    }

    @Test
    void saysWhyAPolicyCannotWalk() throws Exception {
        try (ScriptedServer server = new ScriptedServer(script(2, 5))) {
            Options t1 = options(server).with("robot", "T1");

            assertThatThrownBy(() -> Nao.connect(t1.with("walk", "missing.policy")))
                    .isInstanceOf(StartUpException.class)
                    .hasMessageStartingWith("--walk missing.policy cannot be used: ");
            assertThatThrownBy(() -> Nao.connect(t1.with("robot", "NAO").with("walk", "missing.policy")))
                    .isInstanceOf(StartUpException.class)
                    .hasMessageStartingWith("--walk needs --robot T1 or K1");
        }
    }

    @Test
    void saysWhatToDoWithoutAServer() throws IOException {
        int freePort;
        try (ServerSocket socket = new ServerSocket(0, 1, InetAddress.getLoopbackAddress())) {
            freePort = socket.getLocalPort();
        }
        Options options = Options.none().with("host", "127.0.0.1").with("port", Integer.toString(freePort));

        assertThatThrownBy(() -> Nao.connect(options))
                .isInstanceOf(StartUpException.class)
                .hasMessage(
                        "No simulator answers at 127.0.0.1:" + freePort + ". Start one with \"robonewbie simulator\","
                                + " or omit the host to start one automatically.");
    }

    @Test
    void endsAfterTheWantedTime() throws Exception {
        try (ScriptedServer server = new ScriptedServer(script(2, 200))) {
            Nao nao = Nao.connect(options(server).withSeconds(0.5));
            int cycles = 0;
            while (nao.sense()) {
                nao.act();
                cycles++;
            }
            nao.close();

            assertThat(cycles).isEqualTo(25);
        }
    }

    @Test
    void actsByItselfIfThatWasForgotten() throws Exception {
        try (ScriptedServer server = new ScriptedServer(script(2, 30))) {
            Nao nao = Nao.connect(options(server));
            int cycles = 0;
            while (nao.sense()) {
                cycles++;
            }
            nao.close();

            assertThat(cycles).isEqualTo(30 - 3 - 15);
        }
    }

    @Test
    void reportsAnActWithoutSense() throws Exception {
        try (ScriptedServer server = new ScriptedServer(script(2, 30));
                Nao nao = Nao.connect(options(server))) {
            nao.sense();
            nao.act();
            assertThat(nao.runtime().diagnostics().reported()).isEmpty();

            nao.act();

            assertThat(nao.runtime().diagnostics().reported())
                    .singleElement()
                    .asString()
                    .contains(
                            "act() has no effect: the last message has already been answered; call sense() before each"
                                    + " act().");
        }
    }

    @Test
    void endsAProgramThatSensesAfterTheRobotHasLeft() throws Exception {
        try (ScriptedServer server = new ScriptedServer(script(2, 30))) {
            Nao nao = Nao.connect(options(server));
            nao.close();

            boolean running = nao.sense();

            assertThat(running).isFalse();
            assertThat(nao.runtime().diagnostics().reported())
                    .singleElement()
                    .asString()
                    .contains("The robot has left the game: sense() was called after close().");
        }
    }

    @Test
    void refusesAnAgentThatShallPlayTwice() {
        Agent agent = new Agent() {};

        assertThatThrownBy(() -> AgentRunner.run(List.of(), List.of(agent, agent)))
                .isInstanceOf(StartUpException.class)
                .hasMessage("The same agent was passed twice. Create a separate instance for each robot.");
    }

    @Test
    void refusesAGameWithoutAgents() {
        assertThatThrownBy(() -> AgentRunner.run(List.of(), List.of()))
                .isInstanceOf(StartUpException.class)
                .hasMessage("runTogether needs at least one agent, such as new MyAgent().");
    }

    @Test
    void robotsOfAProgramJoinAServerOneAfterAnother() throws Exception {
        try (ScriptedServer server = new ScriptedServer(script(2, 30))) {
            AgentRunner.run(arguments(server), List.of(new Agent() {}, new Agent() {}, new Agent() {}));

            for (int client = 1; client < 3; client++) {
                List<ScriptedServer.Heard> before = server.heard().subList(0, firstOf(client + 1, server));
                assertThat(before.stream().filter(ofClient(client)).map(ScriptedServer.Heard::message))
                        .startsWith("(scene rsg/agent/nao/nao.rsg)(syn)")
                        .contains("(beam -1 -2 0)(syn)")
                        .hasSizeGreaterThanOrEqualTo(4);
            }
        }
    }

    @Test
    void robotsJoinTogetherWhereAServerWaitsForAllOfThem() throws Exception {
        try (ScriptedServer server = new ScriptedServer(script(2, 30), 3)) {
            int code = AgentRunner.run(arguments(server), List.of(new Agent() {}, new Agent() {}, new Agent() {}));

            assertThat(server.heard().subList(0, 3))
                    .allMatch(heard -> heard.message().startsWith("(scene"));
            assertThat(code).isZero();
        }
    }

    @Test
    void robotThatIsRefusedDoesNotKeepTheNextOneOut() throws Exception {
        try (ScriptedServer server = new ScriptedServer(script(2, 5))) {
            int code = AgentRunner.run(arguments(server), List.of(new Agent() {}, new Agent() {}));

            assertThat(server.heard()).anyMatch(ofClient(2));
            assertThat(code).isEqualTo(2);
        }
    }

    private static int firstOf(int client, ScriptedServer server) {
        List<ScriptedServer.Heard> heard = server.heard();
        return heard.indexOf(heard.stream().filter(ofClient(client)).findFirst().orElseThrow());
    }

    private static Predicate<ScriptedServer.Heard> ofClient(int client) {
        return heard -> heard.client() == client;
    }

    private static List<String> arguments(ScriptedServer server) {
        return List.of("--host", "127.0.0.1", "--port", Integer.toString(server.port()));
    }

    private static Options options(ScriptedServer server) {
        return Options.none().with("host", "127.0.0.1").with("port", Integer.toString(server.port()));
    }

    /** Messages of which one, once, tells the robot its number and side. */
    private static List<PerceptorMessage> script(int tellingMessage, int length) {
        List<PerceptorMessage> script = new ArrayList<>();
        for (int i = 0; i < length; i++) {
            Messages message = Messages.standing()
                    .at(0.02 * i)
                    .in(PlayMode.BEFORE_KICK_OFF)
                    .on(TeamSide.RIGHT);
            script.add((i == tellingMessage ? message : message.withoutNumber()).build());
        }
        return script;
    }
}
