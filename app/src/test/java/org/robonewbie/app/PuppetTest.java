package org.robonewbie.app;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.io.IOException;
import java.net.URI;
import java.net.http.HttpClient;
import java.net.http.HttpRequest;
import java.net.http.HttpResponse;
import java.net.http.WebSocket;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Optional;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.TimeUnit;
import java.util.function.Predicate;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.robonewbie.nao.Joint;
import org.robonewbie.nao.TeamSide;
import org.robonewbie.nao.Vector3;
import org.robonewbie.nao.model.NaoModel;
import org.robonewbie.nao.model.RobotType;
import org.robonewbie.protocol.order.Order;
import org.robonewbie.simulator.Console;
import org.robonewbie.simulator.SimulationControl;
import org.robonewbie.simulator.WorldSnapshot;
import org.robonewbie.simulator.cycle.WorldSettings;
import org.robonewbie.simulator.file.RecordingRepository;
import org.robonewbie.simulator.server.Simulator;
import org.robonewbie.simulator.server.SimulatorSettings;
import org.robonewbie.studio.AccessToken;
import org.robonewbie.studio.StudioCookie;
import org.robonewbie.studio.StudioFolders;
import org.robonewbie.studio.StudioServer;

/** A person without any code: puppets, saved scenes and starting again from a recording, through the studio's own port. */
@Timeout(120)
class PuppetTest {

    private static final int ARM = NaoModel.of(RobotType.TYPE_0).hingeIndex(Joint.LEFT_SHOULDER_PITCH);

    @TempDir
    private Path folder;

    private final BlockingQueue<WorldSnapshot> seen = new LinkedBlockingQueue<>();
    private final HttpClient browser = HttpClient.newHttpClient();
    private Simulator simulator;
    private StudioServer studio;
    private WebSocket page;
    private String cookie = "";

    @BeforeEach
    void open() throws IOException {
        open(Optional.of(folder.resolve("run.rec")));
    }

    private void open(Optional<Path> recording) throws IOException {
        simulator = Simulator.start(
                SimulatorSettings.of(WorldSettings.beginner().withSeed(3))
                        .withAgentPort(0)
                        .withAwaitedAgents(1)
                        .withSpeed(SimulationControl.AS_FAST_AS_POSSIBLE)
                        .withOutput(recording, Optional.empty()),
                Console.silent());
        simulator.control().addObserver(seen::add);
        RecordingRepository shelf = new RecordingRepository(folder, 1_000_000_000);
        StudioFolders folders = new StudioFolders(folder.resolve("motions"), Optional.of(shelf));
        studio = StudioServer.start(simulator.control(), 0, AccessToken.random(), folders);
        cookie = StudioCookie.of(studio.oneTimeAddress());
        page = browser.newWebSocketBuilder()
                .header("Origin", origin())
                .header("Cookie", cookie)
                .buildAsync(
                        URI.create("ws://" + studio.address().getAuthority() + "/live"), new WebSocket.Listener() {})
                .join();
    }

    @AfterEach
    void close() {
        page.abort();
        studio.close();
        simulator.close();
    }

    private String origin() {
        return "http://" + studio.address().getAuthority();
    }

    private void order(String command) {
        page.sendText(command.replace('\'', '"'), true).join();
    }

    private HttpResponse<String> ask(String method, String path) throws IOException, InterruptedException {
        HttpRequest request = HttpRequest.newBuilder(URI.create(origin() + path))
                .header("Cookie", cookie)
                .header("Origin", origin())
                .method(method, HttpRequest.BodyPublishers.noBody())
                .build();
        return browser.send(request, HttpResponse.BodyHandlers.ofString());
    }

    private WorldSnapshot await(Predicate<WorldSnapshot> condition) throws InterruptedException {
        seen.clear();
        WorldSnapshot snapshot = seen.poll(100, TimeUnit.SECONDS);
        while (snapshot != null && !condition.test(snapshot)) {
            snapshot = seen.poll(100, TimeUnit.SECONDS);
        }
        assertThat(snapshot).as("what should be seen").isNotNull();
        return snapshot;
    }

    /** After some reports the studio, which is told after this test, has seen the world too. */
    private void awaitSightOfTheStudio() throws InterruptedException {
        for (int reports = 0; reports < 3; reports++) {
            await(now -> true);
        }
    }

    private static double x(WorldSnapshot snapshot) {
        return snapshot.robots().get(0).body().position().x();
    }

    /** Adds a puppet and waits until it stands behind the ball. */
    private WorldSnapshot addPuppet() throws InterruptedException {
        awaitSightOfTheStudio();
        order("{'do':'addPuppet','side':'left'}");
        long there = await(now -> now.robots().size() == 1
                        && Math.abs(x(now) - now.ballPosition().x() + 0.4) < 0.1)
                .cycle();
        return await(now -> now.cycle() > there + 100);
    }

    @Test
    void puppetWalksAndStops() throws InterruptedException {
        double start = x(addPuppet());

        order("{'do':'walk','side':'left','number':1,'forward':1,'left':0,'turn':0}");
        WorldSnapshot walked = await(now -> x(now) > start + 0.4);
        order("{'do':'walk','side':'left','number':1,'forward':0,'left':0,'turn':0}");
        WorldSnapshot later = walked;
        WorldSnapshot muchLater = afterCycles(100, later);
        while (Math.abs(x(muchLater) - x(later)) > 0.02) {
            later = muchLater;
            muchLater = afterCycles(100, later);
        }

        assertThat(walked.teamLeft()).isEqualTo("Puppets");
    }

    @Test
    void sceneOfAnOlderVersionComesBackNearly() throws Exception {
        addPuppet();
        assertThat(ask("PUT", "/api/scenes/Old").statusCode()).isEqualTo(200);
        Path state = folder.resolve("scenes").resolve("Old.rec.state");
        byte[] bytes = Files.readAllBytes(state);
        bytes["RNSTATE".length()] = 0;
        Files.write(state, bytes);

        String olderVersion = ask("POST", "/api/scenes/Old").body();
        Files.delete(state);
        String withoutState = ask("POST", "/api/scenes/Old").body();

        assertThat(olderVersion).isEqualTo("{\"exact\":false,\"agents\":0}");
        assertThat(withoutState).isEqualTo("{\"exact\":false,\"agents\":0}");
    }

    private WorldSnapshot afterCycles(int cycles, WorldSnapshot start) throws InterruptedException {
        return await(now -> now.cycle() > start.cycle() + cycles);
    }

    @Test
    void sliderMovesOneJoint() throws InterruptedException {
        addPuppet();

        order("{'do':'hold','side':'left','number':1,'joint':'LEFT_SHOULDER_PITCH','degrees':60}");

        WorldSnapshot moved = await(now -> now.robots().get(0).body().hingeDegrees()[ARM] > 59);
        assertThat(await(now -> now.cycle() > moved.cycle() + 50)
                        .robots()
                        .get(0)
                        .body()
                        .hingeDegrees()[ARM])
                .isCloseTo(60, within(1.0));
    }

    @Test
    void puppetIsTakenAway() throws InterruptedException {
        addPuppet();
        order("{'do':'addPuppet','side':'right'}"); // without any agent the world would stand still, and nobody leave
        // it
        await(now -> now.robots().size() == 2);

        order("{'do':'removePuppet','side':'left','number':1}");

        await(now -> now.robots().size() == 1 && now.robots().get(0).side().equals(Optional.of(TeamSide.RIGHT)));
    }

    @Test
    void savedSceneComesBack() throws Exception {
        addPuppet();
        simulator.control().order(new Order.MoveBall(new Vector3(1, 2, 0.042), Vector3.ZERO));
        WorldSnapshot saved = await(now -> now.ballPosition().x() > 0.9);
        awaitSightOfTheStudio();
        assertThat(ask("PUT", "/api/scenes/Corner%202").statusCode()).isEqualTo(200);
        simulator.control().order(new Order.Reset());
        await(now -> now.ballPosition().length() < 0.1);

        HttpResponse<String> taken = ask("PUT", "/api/scenes/Corner%202");
        HttpResponse<String> outside = ask("PUT", "/api/scenes/..%2Fout");
        assertThat(ask("POST", "/api/scenes/Corner%202").body()).isEqualTo("{\"exact\":true,\"agents\":0}");

        WorldSnapshot restored = await(now -> now.paused() && now.ballPosition().x() > 0.9);
        assertThat(x(restored)).isCloseTo(x(saved), within(0.1));
        assertThat(ask("GET", "/api/scenes").body()).contains("\"Corner 2\"");
        assertThat(folder.resolve("scenes").resolve("Corner 2.rec")).exists();
        assertThat(folder.resolve("scenes").resolve("Corner 2.rec.state")).exists();
        assertThat(taken.statusCode()).isEqualTo(409);
        assertThat(taken.body()).isEqualTo("There is already a scene named \"Corner 2\". Choose another name.");
        assertThat(outside.statusCode()).isNotEqualTo(200);
    }

    @Test
    void recordedMomentIsGoneOnFromWithPuppets() throws Exception {
        double start = x(addPuppet());
        order("{'do':'walk','side':'left','number':1,'forward':1,'left':0,'turn':0}");
        WorldSnapshot moment = await(now -> x(now) > start + 0.5);
        await(now -> now.cycle() > moment.cycle() + 120);
        close();
        open(Optional.empty());
        awaitSightOfTheStudio();

        HttpResponse<String> answer = ask("POST", "/api/start/run?moment=" + (moment.cycle() - 1));

        assertThat(answer.body()).isEqualTo("{\"exact\":false,\"agents\":0}");
        WorldSnapshot restored =
                await(now -> now.paused() && now.robots().size() == 1 && Math.abs(x(now) - x(moment)) < 0.02);
        assertThat(restored.teamLeft()).isEqualTo("Puppets");
        assertThat(restored.gameTime()).isCloseTo(moment.gameTime(), within(0.05));
    }

    @Test
    void recordingThatHasGoneCannotBeStartedFrom() throws Exception {
        HttpResponse<String> answer = ask("POST", "/api/start/nothing?moment=5");

        assertThat(answer.statusCode()).isEqualTo(409);
        assertThat(answer.body()).isEqualTo("This recording no longer exists. Choose another one.");
    }
}
