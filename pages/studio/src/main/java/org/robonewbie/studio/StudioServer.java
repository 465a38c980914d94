package org.robonewbie.studio;

import java.io.IOException;
import java.net.InetAddress;
import java.net.URI;
import java.time.Duration;
import java.time.InstantSource;
import java.util.HashMap;
import java.util.Map;
import java.util.Optional;
import java.util.function.IntFunction;
import java.util.logging.Level;
import java.util.logging.Logger;
import org.eclipse.jetty.server.Handler;
import org.eclipse.jetty.server.HttpConfiguration;
import org.eclipse.jetty.server.HttpConnectionFactory;
import org.eclipse.jetty.server.Server;
import org.eclipse.jetty.server.ServerConnector;
import org.eclipse.jetty.util.thread.QueuedThreadPool;
import org.eclipse.jetty.websocket.server.WebSocketUpgradeHandler;
import org.robonewbie.nao.model.NaoModel;
import org.robonewbie.nao.model.RobotType;
import org.robonewbie.protocol.telemetry.TelemetrySink;
import org.robonewbie.simulator.SimulationControl;
import org.robonewbie.simulator.embedded.Viewer;
import org.robonewbie.studio.board.BoardReader;
import org.robonewbie.studio.board.EventBus;
import org.robonewbie.studio.file.FileApi;
import org.robonewbie.studio.file.PageFiles;
import org.robonewbie.studio.motion.MotionApi;
import org.robonewbie.studio.program.CompilerService;
import org.robonewbie.studio.program.ProgramApi;
import org.robonewbie.studio.replay.ReplayApi;
import org.robonewbie.studio.replay.RunNotes;
import org.robonewbie.studio.roboviz.RoboVizFeed;
import org.robonewbie.studio.scene.SceneApi;
import org.robonewbie.studio.service.PageService;

/**
 * Studio for one running simulation: a web server on 127.0.0.1 with the pages and the live feed on one port.
 *
 * <pre>{@code
 * try (StudioServer studio = StudioServer.start(simulation, 0, AccessToken.random())) {
 *     System.out.println(studio.oneTimeAddress());
 * }
 * }</pre>
 */
public final class StudioServer implements Viewer.View {

    /** Strong reference: the log manager holds loggers weakly, and a collected logger loses its level. */
    private static final Logger JETTY_LOGGER = Logger.getLogger("org.eclipse.jetty");

    private static final Duration QUIET_LIMIT = Duration.ofMinutes(10);
    private static final int MAX_COMMAND_BYTES = 4096;

    /** Maximum size of request headers; large, because browsers send the cookies from all ports of this computer. */
    private static final int MAX_HEADER_BYTES = 32_768;

    private static final int MAX_THREADS = 12;

    private final Server server;
    private final LiveFeed feed;
    private final ProgramApi programs;
    private final SignIn signIn;
    private final URI address;

    private StudioServer(Server server, LiveFeed feed, ProgramApi programs, SignIn signIn, int port) {
        this.server = server;
        this.feed = feed;
        this.programs = programs;
        this.signIn = signIn;
        this.address = URI.create("http://127.0.0.1:" + port + "/");
    }

    /**
     * Starts the studio.
     *
     * @param simulation the simulation to show and control
     * @param port TCP port on 127.0.0.1, 0 for any free one
     * @param token the user's secret
     * @return the running studio
     * @throws IOException if the port cannot be opened; the message says what to do
     */
    public static StudioServer start(SimulationControl simulation, int port, AccessToken token) throws IOException {
        return start(simulation, port, token, StudioFolders.ofWorkingDirectory());
    }

    /**
     * Starts the studio with explicit folders.
     *
     * @param simulation the simulation to show and control
     * @param port TCP port on 127.0.0.1, 0 for any free one
     * @param token the user's secret
     * @param folders the folders that the pages may access
     * @return the running studio
     * @throws IOException if the port cannot be opened; the message says what to do
     */
    public static StudioServer start(SimulationControl simulation, int port, AccessToken token, StudioFolders folders)
            throws IOException {
        return start(simulation, port, token, folders, Optional.empty());
    }

    /** Starts the studio with the progress page of an event bus. */
    static StudioServer start(
            SimulationControl simulation, int port, AccessToken token, StudioFolders folders, Optional<EventBus> board)
            throws IOException {
        return start(simulation, port, signIn(token), folders, board, Lessons.NONE);
    }

    /**
     * Starts another studio on any free port. Browsers that are signed in to the first studio are also signed in to this
     * one.
     *
     * @param simulation the simulation to show and control
     * @param first the studio that shares its sign-in
     * @return the running studio
     * @throws IOException if no port can be opened; the message says what to do
     */
    public static StudioServer startBeside(SimulationControl simulation, StudioServer first) throws IOException {
        StudioFolders folders = StudioFolders.ofWorkingDirectory();
        return start(simulation, 0, port -> first.signIn, folders, Optional.empty(), Lessons.NONE);
    }

    private static IntFunction<SignIn> signIn(AccessToken token) {
        return port -> new SignIn(token, port, InstantSource.system());
    }

    /** Starts the studio with exercises and programs. */
    static StudioServer start(
            SimulationControl simulation,
            int port,
            AccessToken token,
            StudioFolders folders,
            Optional<PageService> course,
            Optional<CompilerService> compiler)
            throws IOException {
        Lessons lessons = new Lessons(course, compiler);
        return start(simulation, port, signIn(token), folders, Optional.empty(), lessons);
    }

    /** Optional services for students. */
    private record Lessons(Optional<PageService> course, Optional<CompilerService> compiler) {

        private static final Lessons NONE = new Lessons(Optional.empty(), Optional.empty());
    }

    private static StudioServer start(
            SimulationControl simulation,
            int port,
            IntFunction<SignIn> signInAtPort,
            StudioFolders folders,
            Optional<EventBus> board,
            Lessons lessons)
            throws IOException {
        quietServerLog();
        QueuedThreadPool threads = new QueuedThreadPool(MAX_THREADS, 2);
        threads.setName("studio");
        threads.setDaemon(true);
        Server server = new Server(threads);
        HttpConfiguration http = new HttpConfiguration();
        http.setRequestHeaderSize(MAX_HEADER_BYTES);
        ServerConnector connector = new ServerConnector(server, 1, 1, new HttpConnectionFactory(http));
        connector.setHost(InetAddress.getByAddress(new byte[] {127, 0, 0, 1}).getHostAddress());
        connector.setPort(port);
        server.addConnector(connector);
        openPort(connector, port);

        int openPort = connector.getLocalPort();
        LiveFeed feed = new LiveFeed(simulation, new RunNotes(folders.recordings())::keep);
        SignIn signIn = signInAtPort.apply(openPort);
        AccessRule rule = new AccessRule(openPort);
        String policy = WebFiles.contentSecurityPolicy(openPort);
        WebFiles files = new WebFiles();
        ProgramApi programs = new ProgramApi(lessons.compiler(), new ShownArena(feed));
        Handler rooms = rooms(feed, folders, new CourseApi(lessons.course()), programs, files);
        server.setHandler(new AccessGuard(rule, signIn, policy, live(server, feed, board, rooms)));
        run(server);
        feed.start();
        FirstVisit.start(files, openPort);
        return new StudioServer(server, feed, programs, signIn, openPort);
    }

    private static void quietServerLog() {
        if (JETTY_LOGGER.getLevel() == null) {
            JETTY_LOGGER.setLevel(Level.WARNING);
        }
    }

    private static Handler live(Server server, LiveFeed feed, Optional<EventBus> board, Handler rooms) {
        WebSocketUpgradeHandler live = WebSocketUpgradeHandler.from(server, container -> {
            container.setIdleTimeout(QUIET_LIMIT);
            container.setMaxTextMessageSize(MAX_COMMAND_BYTES);
            container.setMaxBinaryMessageSize(MAX_COMMAND_BYTES);
            container.addMapping(AccessRule.LIVE_PATH, (request, response, callback) -> new Spectator(feed));
            board.ifPresent(
                    news -> container.addMapping(news.path(), (request, response, callback) -> new BoardReader(news)));
        });
        live.setHandler(rooms);
        return live;
    }

    private static Handler rooms(
            LiveFeed feed, StudioFolders folders, CourseApi course, ProgramApi programs, WebFiles files) {
        MotionApi motionRoom =
                new MotionApi(folders.motions(), SceneDescriptionWriter.model(NaoModel.of(RobotType.TYPE_0)));
        ReplayApi replayRoom = new ReplayApi(
                folders.recordings(),
                folders.projects(),
                folders.openedRecording(),
                SceneDescriptionWriter.allModels());
        SceneApi sceneRoom =
                new SceneApi(folders.scenes(), feed.undoManager(), feed.undoManager()::done, replayRoom::recording);
        Map<String, PageFiles> kinds = new HashMap<>(motionRoom.files());
        kinds.putAll(programs.files());
        FileApi fileApi = new FileApi(kinds);
        return new Handler.Sequence(course, programs, sceneRoom, replayRoom, fileApi, motionRoom, files);
    }

    private static void openPort(ServerConnector connector, int port) throws IOException {
        try {
            connector.open();
        } catch (IOException e) {
            throw new IOException(
                    "The studio cannot use port " + port + " of 127.0.0.1; another program is probably using it. "
                            + "Stop that program, or choose another port (0 = any free one).",
                    e);
        }
    }

    @SuppressWarnings("IllegalCatch")
    private static void run(Server server) throws IOException {
        try {
            server.start();
        } catch (Exception e) {
            throw new IOException("The studio's web server failed to start: " + e.getMessage(), e);
        }
    }

    @Override
    public URI address() {
        return address;
    }

    @Override
    public URI oneTimeAddress() {
        return signIn.newAddress(address);
    }

    @Override
    public boolean isWatched() {
        return feed.spectators() > 0;
    }

    @Override
    public TelemetrySink telemetry() {
        return feed;
    }

    /** {@return the drawings received through the RoboViz protocol} */
    public RoboVizFeed drawings() {
        return feed.board();
    }

    LiveFeed feed() {
        return feed;
    }

    int spectators() {
        return feed.spectators();
    }

    @Override
    public void close() {
        programs.close();
        feed.close();
        try {
            server.stop();
        } catch (Exception e) {
            throw new IllegalStateException("The studio's web server failed to stop: " + e.getMessage(), e);
        }
    }
}
