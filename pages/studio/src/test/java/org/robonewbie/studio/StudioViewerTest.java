package org.robonewbie.studio;

import static org.assertj.core.api.Assertions.assertThat;

import com.google.gson.JsonArray;
import com.google.gson.JsonObject;
import java.io.IOException;
import java.net.URI;
import java.nio.file.Path;
import java.util.Optional;
import java.util.ServiceLoader;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.robonewbie.protocol.frame.AgentLink;
import org.robonewbie.protocol.frame.MessageBuffer;
import org.robonewbie.simulator.Console;
import org.robonewbie.simulator.cycle.WorldSettings;
import org.robonewbie.simulator.embedded.Viewer;
import org.robonewbie.simulator.server.Simulator;
import org.robonewbie.simulator.server.SimulatorSettings;

/** The studio as found and used by the simulator. */
class StudioViewerTest {

    @TempDir
    private Path home;

    private final String usersHome = System.getProperty("user.home");
    private final Viewer viewer = ServiceLoader.load(Viewer.class).findFirst().orElseThrow();

    @BeforeEach
    void moveHome() {
        System.setProperty("user.home", home.toString());
    }

    @AfterEach
    void moveBack() {
        System.setProperty("user.home", usersHome);
    }

    @Test
    void nextRunHasTheSameAddress() throws IOException {
        try (TestSimulator simulation = new TestSimulator()) {
            URI first = addressOfARun(simulation, 0);

            assertThat(addressOfARun(simulation, first.getPort())).isEqualTo(first);
        }
    }

    private URI addressOfARun(TestSimulator simulation, int usualPort) throws IOException {
        try (Viewer.View view = openAtUsual(usualPort, simulation)) {
            return view.address();
        }
    }

    private Viewer.View openAtUsual(int usualPort, TestSimulator simulation) throws IOException {
        StudioFolders folders = new StudioFolders(home, Optional.empty());
        return StudioViewer.openAtUsual(
                usualPort, port -> StudioServer.start(simulation.control(), port, AccessToken.ofUser(), folders));
    }

    @Test
    void secondRunAtTheSameTimeTakesAnotherPort() throws IOException {
        try (TestSimulator simulation = new TestSimulator();
                Viewer.View first = openAtUsual(0, simulation);
                Viewer.View second = openAtUsual(first.address().getPort(), simulation)) {
            assertThat(second.address().getPort()).isNotEqualTo(first.address().getPort());
        }
    }

    @Test
    void robotOfTheRealSimulatorIsSeenAndStepped() throws Exception {
        SimulatorSettings settings = SimulatorSettings.of(
                        WorldSettings.beginner().withSeed(1))
                .withAgentPort(0)
                .withAwaitedAgents(1);
        try (Simulator simulator = Simulator.start(settings, Console.standard());
                Viewer.View view = viewer.open(simulator.control(), 0);
                AgentLink agent = simulator.connect();
                TestPage page = new TestPage(view.oneTimeAddress())) {
            Thread robot = new Thread(() -> live(agent), "robot");
            robot.setDaemon(true);
            robot.start();

            page.awaitScene(StudioViewerTest::hasNumberedRobot);
            page.send("{\"do\":\"pause\"}");
            long paused = page.nextPausedCycle();
            page.send("{\"do\":\"step\",\"cycles\":7}");

            assertThat(page.nextCycleFrom(paused + 7)).isEqualTo(paused + 7);
            page.seen();
            assertThat(TestPage.cycleOf(page.nextFrame())).as("still standing").isEqualTo(paused + 7);
            assertThat(view.isWatched()).isTrue();
        }
    }

    private static boolean hasNumberedRobot(JsonObject scene) {
        JsonArray robots = scene.getAsJsonArray("robots");
        return !robots.isEmpty()
                && robots.get(0).getAsJsonObject().get("number").getAsInt() == 4;
    }

    private static void live(AgentLink agent) {
        try {
            MessageBuffer message = new MessageBuffer();
            String[] greeting = {"(scene rsg/agent/nao/nao.rsg)(syn)", "(init (unum 4)(teamname Tests))(syn)"};
            for (int cycle = 0; true; cycle++) {
                message.clear();
                message.append(cycle < greeting.length ? greeting[cycle] : "(syn)");
                agent.send(message);
                if (!agent.receive(message)) {
                    return;
                }
            }
        } catch (IOException e) {
            // The simulator has ended.
        }
    }
}
