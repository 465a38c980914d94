package org.robonewbie.simulator.embedded;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import com.google.gson.JsonObject;
import com.google.gson.JsonParser;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.OptionalLong;
import java.util.ServiceLoader;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.robonewbie.protocol.embedded.EmbeddedSimulator;
import org.robonewbie.protocol.embedded.SimulatorProvider;
import org.robonewbie.protocol.embedded.SimulatorRequest;
import org.robonewbie.protocol.frame.AgentLink;
import org.robonewbie.protocol.frame.MessageBuffer;
import org.robonewbie.protocol.tcp.TcpAgentLink;

@Timeout(120)
class BeginnersSimulatorProviderTest {

    @TempDir
    private Path folder;

    private final SimulatorProvider provider =
            ServiceLoader.load(SimulatorProvider.class).findFirst().orElseThrow();

    @Test
    void isFoundAsService() {
        assertThat(provider).isInstanceOf(BeginnersSimulatorProvider.class);
    }

    @Test
    void endsAfterTheWantedTimeAndLeavesReportAndRecording() throws IOException {
        Path report = folder.resolve("report.json");
        Path recording = folder.resolve("run.rec");
        int messages = 0;

        try (EmbeddedSimulator simulator =
                        provider.start(request(OptionalDouble.of(2), Optional.of(report), Optional.of(recording)));
                AgentLink agent = simulator.connect()) {
            messages = talkUntilTheEnd(agent);
        }

        JsonObject json = JsonParser.parseString(Files.readString(report)).getAsJsonObject();
        assertThat(messages).isBetween(97, 99);
        assertThat(json.get("simulatedSeconds").getAsDouble()).isEqualTo(2);
        assertThat(json.get("seed").getAsLong()).isEqualTo(4);
        assertThat(json.getAsJsonArray("robots")).hasSize(1);
        assertThat(recording).exists();
    }

    @Test
    void sameSeedGivesSameReport() throws IOException {
        assertThat(hashOfRun()).isEqualTo(hashOfRun());
    }

    @Test
    void clockStandsStillUntilTheAwaitedAgentIsThere() throws IOException {
        try (EmbeddedSimulator simulator =
                        provider.start(request(OptionalDouble.empty(), Optional.empty(), Optional.empty()));
                AgentLink agent = simulator.connect()) {
            MessageBuffer message = new MessageBuffer();

            say(agent, "(scene rsg/agent/nao/nao.rsg)(syn)");
            agent.receive(message);

            assertThat(message.toString()).startsWith("(time (now 0.04))");
        }
    }

    @Test
    void agentsOfOtherProcessesCanJoin() throws IOException {
        try (EmbeddedSimulator simulator =
                        provider.start(request(OptionalDouble.empty(), Optional.empty(), Optional.empty()));
                AgentLink visitor = TcpAgentLink.connect("127.0.0.1", simulator.agentPort())) {
            MessageBuffer message = new MessageBuffer();

            say(visitor, "(scene rsg/agent/nao/nao.rsg)(syn)");

            assertThat(visitor.receive(message)).isTrue();
        }
    }

    @Test
    void unwritableReportIsExplainedWhenClosing() throws IOException {
        Path report = folder.resolve("missing").resolve("report.json");
        EmbeddedSimulator simulator =
                provider.start(request(OptionalDouble.empty(), Optional.of(report), Optional.empty()));

        assertThatThrownBy(simulator::close)
                .isInstanceOf(UncheckedIOException.class)
                .hasMessageContaining("Choose a file in an existing folder");
    }

    @Test
    void unwritableRecordingIsExplainedAtOnce() {
        Path recording = folder.resolve("missing").resolve("run.rec");

        assertThatThrownBy(
                        () -> provider.start(request(OptionalDouble.empty(), Optional.empty(), Optional.of(recording))))
                .isInstanceOf(IOException.class)
                .hasMessageContaining("Choose a file in an existing folder");
    }

    @Test
    void unknownSceneIsExplainedAtOnce() {
        assertThatThrownBy(() -> provider.start(
                        requestFor(OptionalDouble.empty(), Optional.of("moon"), Optional.empty(), Optional.empty())))
                .isInstanceOf(IOException.class)
                .hasMessageContaining("There is no scene \"moon\"");
    }

    @Test
    void closingTwiceDoesNothing() throws IOException {
        EmbeddedSimulator simulator =
                provider.start(request(OptionalDouble.empty(), Optional.empty(), Optional.empty()));

        simulator.close();
        simulator.close();

        assertThat(simulator.studioAddress()).isEmpty();
    }

    @Test
    void browserIsOpenedWithTheCommandOfTheSystem() {
        Path page = folder.resolve("open.html");

        assertThat(Browser.command("Windows 11", page)).startsWith("rundll32").endsWith(page.toString());
        assertThat(Browser.command("Mac OS X", page)).containsExactly("open", page.toString());
        assertThat(Browser.command("Linux", page)).containsExactly("xdg-open", page.toString());
    }

    private String hashOfRun() throws IOException {
        Path report = folder.resolve("report.json");
        try (EmbeddedSimulator simulator =
                        provider.start(request(OptionalDouble.of(2), Optional.of(report), Optional.empty()));
                AgentLink agent = simulator.connect()) {
            talkUntilTheEnd(agent);
        }
        return JsonParser.parseString(Files.readString(report))
                .getAsJsonObject()
                .get("recordingSha256")
                .getAsString();
    }

    private static int talkUntilTheEnd(AgentLink agent) throws IOException {
        MessageBuffer message = new MessageBuffer();
        int messages = 0;
        say(agent, "(scene rsg/agent/nao/nao.rsg)(syn)");
        while (agent.receive(message)) {
            messages++;
            say(agent, messages == 1 ? "(init (unum 1)(teamname Stars))(syn)" : "(lae1 1)(syn)");
        }
        return messages;
    }

    private static void say(AgentLink agent, String text) throws IOException {
        MessageBuffer message = new MessageBuffer();
        message.append(text);
        agent.send(message);
    }

    private static SimulatorRequest request(OptionalDouble seconds, Optional<Path> report, Optional<Path> recording) {
        return requestFor(seconds, Optional.empty(), report, recording);
    }

    private static SimulatorRequest requestFor(
            OptionalDouble seconds, Optional<String> scene, Optional<Path> report, Optional<Path> recording) {
        return new SimulatorRequest(
                "NAO",
                0,
                OptionalLong.of(4),
                true,
                seconds,
                true,
                false,
                false,
                scene,
                report.map(Path::toString),
                recording.map(Path::toString),
                1,
                "Ada");
    }
}
