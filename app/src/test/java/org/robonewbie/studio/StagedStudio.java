package org.robonewbie.studio;

import com.google.gson.Gson;
import com.google.gson.JsonElement;
import com.google.gson.JsonObject;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.EnumMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalInt;
import org.robonewbie.app.studio.LocalCourseHost;
import org.robonewbie.app.studio.ProcessCompilerService;
import org.robonewbie.exercises.progress.LocalProgress;
import org.robonewbie.exercises.progress.ProgressFile;
import org.robonewbie.exercises.progress.ProgressService;
import org.robonewbie.exercises.progress.SolutionRepository;
import org.robonewbie.exercises.service.CourseService;
import org.robonewbie.nao.Joint;
import org.robonewbie.nao.TeamSide;
import org.robonewbie.nao.model.RobotType;
import org.robonewbie.protocol.monitor.FoulType;
import org.robonewbie.protocol.order.Order;
import org.robonewbie.protocol.tcp.TelemetryServer;
import org.robonewbie.protocol.telemetry.TelemetryLine;
import org.robonewbie.simulator.cycle.WorldSettings;
import org.robonewbie.simulator.embedded.RedirectPage;
import org.robonewbie.simulator.file.RecordingRepository;
import org.robonewbie.simulator.landscape.Landscape;
import org.robonewbie.simulator.server.SimulatorSettings;
import org.robonewbie.simulator.server.SimulatorSettings.Monitors;
import org.robonewbie.simulator.soccer.MatchEvent;
import org.robonewbie.studio.board.EventBus;
import org.robonewbie.studio.monitor.MonitoredSimulation;
import org.robonewbie.studio.roboviz.RoboVizPort;

/** A studio with all rooms, as {@code robonewbie studio} opens it, whose programs, motions, recordings and progress lie in one folder. */
final class StagedStudio implements AutoCloseable {

    private static final int SHELF_BYTES = 1_000_000_000;
    private static final double MONITOR_SECONDS = 0.04;

    private final TestSimulator simulation;
    private final Optional<MonitoredSimulation> watched;
    private final ProcessCompilerService programs;
    private final CourseService course;
    private final TelemetryServer telemetry;
    private final Optional<StagedWall> wall;
    private final StudioServer studio;
    private final AccessToken token;
    private final RoboVizPort drawings;
    private final Optional<StagedSearch> search;

    /**
     * Opens the studio.
     *
     * @param request JSON object with its folder, and with robots that hold a posture or a world that waits for its first robot
     */
    StagedStudio(JsonObject request) throws IOException {
        this(request, 0, AccessToken.random());
    }

    private StagedStudio(JsonObject request, int port, AccessToken token) throws IOException {
        this.token = token;
        Path folder = Path.of(text(request, "folder", ""));
        boolean isForeign = isSet(request, "isForeign");
        Robot[] robots = new Gson().fromJson(request.get("robots"), Robot[].class);
        simulation = new TestSimulator(SimulatorSettings.of(WorldSettings.beginner()
                        .withLandscape(Landscape.named(text(request, "landscape", "soccer")))
                        .withSeed(1))
                .withAgentPort(0)
                .withMonitors(new Monitors(
                        isForeign ? OptionalInt.of(0) : OptionalInt.empty(), MONITOR_SECONDS, true, Optional.empty()))
                .withAwaitedAgents(robots == null ? 1 : 0)
                .withSpeed(Double.parseDouble(text(request, "speed", "1"))));
        for (Robot robot : robots == null ? new Robot[0] : robots) {
            robot.joins(simulation);
        }
        if (isSet(request, "isPlaying")) {
            PlayingRobot.start(simulation.control().connect().orElseThrow());
        }
        if (isSet(request, "isPaused")) {
            simulation.order(new Order.Pause());
        }
        for (String name : new Gson().fromJson(text(request, "recordings", "[]"), String[].class)) {
            Path file = folder.resolve(name + RecordingRepository.ENDING);
            Files.createDirectories(file.getParent());
            RecordedRun.write(file);
        }
        watched = isForeign ? Optional.of(simulation.watched()) : Optional.empty();
        search = Optional.ofNullable(request.get("search")).map(StagedSearch::new);
        wall = isSet(request, "hasWall") ? Optional.of(new StagedWall()) : Optional.empty();
        ShownSimulation shown = new ShownSimulation(simulation.control());
        programs = new ProcessCompilerService(folder);
        course = new CourseService(
                new ProgressService(
                        new LocalProgress(Optional.of(new ProgressFile(folder.resolve("progress.json")))),
                        SolutionRepository.ofFolder(folder.resolve("solutions"))),
                new LocalCourseHost(folder, simulation.control(), shown),
                "");
        course.setLanguage(text(request, "language", "en"));
        String opened = text(request, "openedRecording", "");
        StudioFolders folders = new StudioFolders(
                folder,
                folder.resolve("scenes"),
                Optional.of(new RecordingRepository(folder, SHELF_BYTES)),
                List.of(folder.resolve("project")),
                opened.isEmpty() ? Optional.empty() : Optional.of(folder.resolve(opened + RecordingRepository.ENDING)));
        studio = start(shown, port, folders);
        drawings = RoboVizPort.open(0, studio.drawings());
        telemetry = TelemetryServer.open(
                isForeign ? 0 : TelemetryServer.portFor(simulation.agentPort()), studio.telemetry());
    }

    /** Starts the server. A foreign simulation and the pages of a contest or an optimisation have no exercises. */
    private StudioServer start(ShownSimulation shown, int port, StudioFolders folders) throws IOException {
        if (watched.isPresent()) {
            return StudioServer.start(watched.get(), port, token, folders);
        }
        Optional<EventBus> board = search.<EventBus>map(StagedSearch::feed).or(() -> wall.map(StagedWall::wall));
        return board.isPresent()
                ? StudioServer.start(shown, port, token, folders, board)
                : StudioServer.start(shown, port, token, folders, Optional.of(course::answer), Optional.of(programs));
    }

    private static boolean isSet(JsonObject request, String key) {
        return request.has(key) && request.get(key).getAsBoolean();
    }

    private static String text(JsonObject request, String key, String other) {
        JsonElement value = request.get(key);
        return value == null ? other : value.isJsonPrimitive() ? value.getAsString() : value.toString();
    }

    /** A robot that stands on the pitch, as the tests describe it; what is missing has a default. */
    private static final class Robot {

        private TeamSide side = TeamSide.LEFT;
        private int number = 1;
        private int type;
        private double x = -0.8;
        private double y = 0.3;
        private double heading;
        private Map<Joint, Double> posture = Posture.STANDING;

        void joins(TestSimulator simulation) {
            simulation.withRobot(RobotType.values()[type], side, number, x, y, heading, new EnumMap<>(posture));
        }
    }

    TestSimulator simulation() {
        return simulation;
    }

    /** Returns an address of the page, which works once. */
    String address() {
        return studio.oneTimeAddress().toString();
    }

    /** Writes a page file to a folder, which leads to an address of the page that works once, and returns its path. */
    String pageFile(String folder) throws IOException {
        String home = System.setProperty("user.home", folder);
        try {
            return RedirectPage.write(studio.oneTimeAddress()).toString();
        } finally {
            System.setProperty("user.home", home);
        }
    }

    /** Returns the wall of a contest that the studio shows. */
    StagedWall wall() {
        return wall.orElseThrow();
    }

    /** Returns the UDP port for drawings in the protocol of RoboViz. */
    int drawingPort() {
        return drawings.number();
    }

    /** Passes a line of telemetry to the studio, as from a robot's program. */
    void tell(String line) {
        studio.telemetry().accept(TelemetryLine.read(line).orElseThrow());
    }

    /** Reports that the first robot of the left team runs into an opponent. */
    void callFoul() {
        studio.feed().happened(new MatchEvent.FoulCalled(FoulType.CHARGING, TeamSide.LEFT, 1));
    }

    /** Opens another studio at the address of this one, which is closed. */
    StagedStudio restarted(JsonObject request) throws IOException {
        return new StagedStudio(request, studio.address().getPort(), token);
    }

    /** Returns the optimisation that the studio shows instead of the course. */
    StagedSearch search() {
        return search.orElseThrow();
    }

    /** Executes a command of the page that changes the world. */
    void order(String command) {
        StudioRequest request = StudioRequestReader.read(command);
        List<Order> orders = request instanceof StudioRequest.Change change
                ? change.orders()
                : ((StudioRequest.Orders) request).orders();
        orders.forEach(simulation::order);
    }

    @Override
    public void close() {
        wall.ifPresent(StagedWall::close);
        drawings.close();
        studio.close();
        watched.ifPresent(MonitoredSimulation::close);
        programs.close();
        course.close();
        telemetry.close();
        simulation.close();
    }
}
