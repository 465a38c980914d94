package org.robonewbie.studio;

import static org.assertj.core.api.Assertions.assertThat;

import com.google.gson.JsonParser;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.stream.Stream;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.robonewbie.agent.Agent;
import org.robonewbie.examples.Agent_BetterSoccer;
import org.robonewbie.examples.Agent_SimpleSoccer;
import org.robonewbie.examples.Agent_SimpleWalkToBall;

/** A run in the page and on the JVM is identical bit for bit. */
@InBrowser
@Timeout(300)
class SameRunInThePageTest {

    private static final Path PAGE = Path.of("target", "web");
    private static final int SECONDS = 60;

    @TempDir
    private Path folder;

    private final Chromium browser;
    private StaticServer server;

    SameRunInThePageTest(Chromium browser) {
        this.browser = browser;
    }

    @BeforeEach
    void serve() throws IOException {
        server = new StaticServer(PAGE.toAbsolutePath());
    }

    @AfterEach
    void end() {
        server.close();
    }

    static Stream<Agent> agents() {
        return Stream.of(new Agent_BetterSoccer(), new Agent_SimpleSoccer(), new Agent_SimpleWalkToBall());
    }

    @ParameterizedTest
    @MethodSource("agents")
    void aMinuteHasTheSameRecordingInThePageAndOnTheJvm(Agent agent) throws IOException {
        browser.visit(server.address() + "webassembly-loader.js");
        String there = browser.evaluate(recordingOf(agent)).getAsString();

        assertThat(there).isEqualTo(recordingOnTheJvm(agent));
    }

    @ParameterizedTest
    @MethodSource("agents")
    void aMinuteHasTheSameRecordingInFirefox(Agent agent, @TempDir Path profile) throws IOException {
        try (Firefox firefox = Firefox.start(profile)) {
            firefox.visit(server.address() + "webassembly-loader.js");
            String there = firefox.evaluate(recordingOf(agent)).getAsString();

            assertThat(there).isEqualTo(recordingOnTheJvm(agent));
        }
    }

    private static String recordingOf(Agent agent) {
        return "new Promise((answer) => {"
                + " const worker = new Worker('world-worker.js', { type: 'module' });"
                + " worker.onmessage = ({ data }) => answer(data.result ?? data.failure);"
                + " worker.onerror = (event) => answer(event.message);"
                + " worker.postMessage({ call: { name: 'recordingSha256', args: ['"
                + agent.getClass().getSimpleName() + "', 1, " + SECONDS + "] } });"
                + "})";
    }

    /** Runs the agent as the command line does. */
    private String recordingOnTheJvm(Agent agent) throws IOException {
        Path report = folder.resolve("report.json");
        agent.run("--headless", "--fast", "--seed", "1", "--seconds", "" + SECONDS, "--report", report.toString());
        return JsonParser.parseString(Files.readString(report))
                .getAsJsonObject()
                .get("recordingSha256")
                .getAsString();
    }
}
