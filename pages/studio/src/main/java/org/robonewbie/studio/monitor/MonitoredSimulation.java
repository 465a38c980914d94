package org.robonewbie.studio.monitor;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.TimeoutException;
import java.util.concurrent.locks.LockSupport;
import java.util.function.Supplier;
import org.robonewbie.nao.PlayMode;
import org.robonewbie.nao.SoccerField;
import org.robonewbie.nao.Vector3;
import org.robonewbie.protocol.monitor.MonitoredGame;
import org.robonewbie.protocol.monitor.MonitoredWorld;
import org.robonewbie.protocol.monitor.RsmpWorld;
import org.robonewbie.protocol.order.Order;
import org.robonewbie.protocol.tcp.MonitorLink;
import org.robonewbie.simulator.PitchDetails;
import org.robonewbie.simulator.SimulationControl;
import org.robonewbie.simulator.SimulationObserver;
import org.robonewbie.simulator.WorldSnapshot;
import org.robonewbie.simulator.file.RecordingFile;
import org.robonewbie.simulator.soccer.MatchEvent;

/**
 * A remote simulation, watched and controlled through the monitor port of a SimSpark server (protocol: SimSpark's
 * {@code sparkmonitor.cpp} and {@code trainercommandparser.cpp}) or of RCSSServerMJ ({@code soccer_command_parser.py}). Reconnects
 * when the server is restarted.
 *
 * <p>A monitor cannot stop the server's clock, so pause, step and speed are refused.
 *
 * <pre>{@code
 * MonitoredSimulation match = MonitoredSimulation.connect("127.0.0.1", 3200);
 * StudioServer.start(match, 0, AccessToken.random());
 * }</pre>
 */
public final class MonitoredSimulation implements SimulationControl, AutoCloseable {

    private static final String NO_CLOCK = "A simulation in another process cannot be paused or sped up.";
    private static final String MONITOR_START = "((";
    private static final String CLOSED =
            "The server at %s:%d closed the connection when asked for the state of the match. RCSSServerMJ, the server of"
                    + " today's league, does so at its agent port; it is watched at its monitor port, which is usually 60001.";
    private static final String AGENT_PORT =
            "%s:%d is the agent port of a SimSpark server. It is watched at its monitor port, which is usually 3200.";
    private static final long MAX_SILENCE_SECONDS = 5;
    private static final long MAX_END_MILLIS = 3000;
    private static final long RETRY_NANOS = TimeUnit.SECONDS.toNanos(1);

    private final String host;
    private final int port;
    private final OptionalInt agentPort;
    private final List<SimulationObserver> observers = new CopyOnWriteArrayList<>();
    private final Thread thread = new Thread(this::listen, "studio-monitor");
    private final MonitorClock clock = new MonitorClock();
    private volatile MonitorLink link;
    private volatile SoccerField field = SoccerField.LEAGUE;
    private volatile PitchDetails details = PitchDetails.SIMSPARK;
    private volatile boolean isLeague;
    private volatile Optional<WorldSnapshot> lastSnapshot = Optional.empty();
    private final CompletableFuture<Optional<String>> mistakeAtStart = new CompletableFuture<>();
    private boolean silent;
    private volatile boolean open = true;
    private final Supplier<Optional<Path>> recording;
    private final List<MatchEvent> newEvents = new ArrayList<>();
    private Optional<MonitorRecorder> recorder = Optional.empty();
    private boolean hasRecorder;
    private boolean hasProblem;
    private MonitoredGame lastGame = MonitoredGame.UNKNOWN;

    private MonitoredSimulation(
            String host, int port, OptionalInt agentPort, Supplier<Optional<Path>> recording, MonitorLink link) {
        this.recording = recording;
        this.host = host;
        this.port = port;
        this.agentPort = agentPort;
        this.link = link;
        thread.setDaemon(true);
    }

    /**
     * Connects to a server and starts watching it.
     *
     * @param host host name or IP address of the server
     * @param port its monitor port, 3200 by default
     * @return the remote simulation
     * @throws IOException if no server responds; the message says what to do
     */
    public static MonitoredSimulation connect(String host, int port) throws IOException {
        return connect(host, port, OptionalInt.empty(), Optional::empty);
    }

    /**
     * Connects to a server and starts watching it.
     *
     * @param host host name or IP address of the server
     * @param port its monitor port
     * @param agentPort its agent port, if the studio may start programs that join it
     * @param recording names the file to which a match of RCSSServerMJ is recorded; called once such a match is seen
     * @return the remote simulation
     * @throws WrongPortException if the port is an agent port
     * @throws IOException if no server responds; the message says what to do
     */
    public static MonitoredSimulation connect(
            String host, int port, OptionalInt agentPort, Supplier<Optional<Path>> recording) throws IOException {
        MonitorLink link = MonitorLink.connect(host, port);
        link.send(new Order.RequestFullState());
        MonitoredSimulation simulation = new MonitoredSimulation(host, port, agentPort, recording, link);
        simulation.thread.start();
        simulation.awaitFirstMessage();
        return simulation;
    }

    /**
     * Waits for the first message. An agent port is recognised by what it does after a message for a monitor port: SimSpark's sends
     * what a robot senses, and RCSSServerMJ closes the connection. A silent server may be busy, so it is not refused.
     */
    private void awaitFirstMessage() throws IOException {
        Optional<String> mistake;
        try {
            mistake = mistakeAtStart.get(MAX_SILENCE_SECONDS, TimeUnit.SECONDS);
        } catch (TimeoutException stillSilent) {
            silent = mistakeAtStart.complete(Optional.empty());
            return;
        } catch (InterruptedException | ExecutionException stopped) {
            throw new IOException("Watching was interrupted.", stopped);
        }
        if (mistake.isPresent()) {
            throw new WrongPortException(mistake.get());
        }
    }

    /** {@return whether the server sent nothing in the first seconds} */
    public boolean wasSilent() {
        return silent;
    }

    private void listen() {
        while (open) {
            try {
                while (link.receive() && isMonitorPort()) {
                    take(link.world());
                    mistakeAtStart.complete(Optional.empty());
                }
            } catch (IOException lost) {
                // The server has stopped; reconnect below.
            }
            link.close();
            if (mistakeAtStart.complete(Optional.of(CLOSED.formatted(host, port)))) {
                return;
            }
            seekAgain();
        }
        recorder.ifPresent(MonitorRecorder::close);
    }

    /** Returns whether the last message is for monitors: a list of lists. Messages to agents are named lists. */
    private boolean isMonitorPort() {
        boolean isMonitorPort = link.lastMessage().startsWith(MONITOR_START);
        if (!isMonitorPort) {
            mistakeAtStart.complete(Optional.of(AGENT_PORT.formatted(host, port)));
        }
        return isMonitorPort;
    }

    private void seekAgain() {
        while (open) {
            LockSupport.parkNanos(RETRY_NANOS);
            try {
                MonitorLink found = MonitorLink.connect(host, port);
                link = found;
                if (!open) {
                    found.close();
                }
                return;
            } catch (IOException stillAway) {
                // Retry until the server is up again.
            }
        }
    }

    private void take(MonitoredWorld world) throws IOException {
        isLeague = world.rsmp().isPresent();
        reportProblem(world);
        if (!world.isCurrent()) {
            if (!isLeague) {
                link.send(new Order.RequestFullState());
            }
            return;
        }
        field = MonitorSnapshots.field(world);
        details = MonitorSnapshots.details(world);
        clock.tick(world);
        reportEvents(world);
        WorldSnapshot snapshot =
                MonitorSnapshots.of(world, clock.cycle(), clock.realTimeFactor(), clock.isStandingStill());
        record(world, snapshot);
        synchronized (observers) {
            lastSnapshot = Optional.of(snapshot);
            observers.forEach(observer -> observer.cycleEnded(snapshot));
        }
    }

    /** Records a match of RCSSServerMJ, which keeps no recording that could be replayed without this program. */
    private void record(MonitoredWorld world, WorldSnapshot snapshot) throws IOException {
        if (isLeague && !hasRecorder) {
            hasRecorder = true;
            Optional<Path> file = recording.get();
            if (file.isPresent()) {
                RecordingFile target = RecordingFile.open(
                        file.get(), sentence -> observers.forEach(observer -> observer.messagePrinted(sentence)));
                recorder = Optional.of(MonitorRecorder.open(target, world));
            }
        }
        recorder.ifPresent(target -> {
            newEvents.forEach(target::happened);
            target.write(snapshot);
        });
        newEvents.clear();
    }

    /** Reports the first message that is not understood; the next ones usually follow from it. */
    private void reportProblem(MonitoredWorld world) {
        Optional<RsmpWorld.Problem> problem = world.rsmp().flatMap(RsmpWorld::problem);
        if (problem.isPresent() && !hasProblem) {
            String sentence = "The server sent what this version cannot read. " + problem.get()
                    + " The picture goes on with the next complete scene.";
            observers.forEach(observer -> observer.messagePrinted(sentence));
        }
        hasProblem = problem.isPresent();
    }

    private void reportEvents(MonitoredWorld world) {
        world.newFouls().forEach(foul -> report(MonitorEvents.of(foul)));
        MonitorEvents.between(lastGame, world.gameState()).forEach(this::report);
        lastGame = world.gameState();
    }

    private void report(MatchEvent event) {
        newEvents.add(event);
        observers.forEach(observer -> observer.happened(event));
    }

    private void send(Order.Trainer... orders) {
        try {
            link.send(orders);
        } catch (IOException lost) {
            throw new IllegalStateException(
                    "The server at " + host + ":" + port + " is no longer reachable. Start it again.", lost);
        }
    }

    @Override
    public SoccerField field() {
        return field;
    }

    @Override
    public PitchDetails pitchDetails() {
        return details;
    }

    @Override
    public OptionalInt agentPort() {
        return agentPort;
    }

    @Override
    public boolean hasClock() {
        return false;
    }

    @Override
    public boolean canSetMatch() {
        return !isLeague;
    }

    @Override
    public void order(Order order) {
        if (order instanceof Order.Clock) {
            throw new UnsupportedOperationException(NO_CLOCK);
        } else if (isLeague) {
            orderLeague(order);
        } else if (order instanceof Order.Trainer known) {
            send(known);
        } else if (order instanceof Order.PlaceRobot place) {
            send(new Order.MoveAndTurnRobot(place.player(), place.position(), place.headingDegrees() - 90));
        } else if (order instanceof Order.Reset) {
            reset();
        }
    }

    /**
     * Sends an order that RCSSServerMJ executes, and ignores all others. Unlike SimSpark, it measures the heading from the x axis, and
     * needs the position of a ball that is thrown.
     */
    private void orderLeague(Order order) {
        if (order instanceof Order.KickOff || order instanceof Order.DropBall) {
            send((Order.Trainer) order);
        } else if (order instanceof Order.PlaceRobot place) {
            send(new Order.MoveAndTurnRobot(place.player(), place.position(), place.headingDegrees()));
        } else if (order instanceof Order.MoveBall move) {
            Vector3 now = lastSnapshot.map(WorldSnapshot::ballPosition).orElse(Vector3.ZERO);
            Vector3 position = move.position().orElse(now);
            double height = Math.max(details.ballRadius(), position.z());
            send(new Order.MoveBall(Optional.of(new Vector3(position.x(), position.y(), height)), move.velocity()));
        }
    }

    /** Resets the ball, the clock and the score to the start of the game; robots stay where they are. */
    private void reset() {
        send(
                new Order.ChangePlayMode(PlayMode.BEFORE_KICK_OFF),
                new Order.SetTime(0),
                new Order.SetScore(0, 0),
                new Order.MoveBall(new Vector3(0, 0, SoccerField.BALL_RADIUS), Vector3.ZERO));
    }

    /** Adds an observer, and passes it the last scene: the server may never send another one. */
    @Override
    public void addObserver(SimulationObserver observer) {
        synchronized (observers) {
            observers.add(observer);
            lastSnapshot.ifPresent(observer::cycleEnded);
        }
    }

    @Override
    public void removeObserver(SimulationObserver observer) {
        observers.remove(observer);
    }

    @Override
    public void close() {
        open = false;
        link.close();
        LockSupport.unpark(thread);
        try {
            thread.join(MAX_END_MILLIS);
        } catch (InterruptedException stopped) {
            Thread.currentThread().interrupt();
        }
    }
}
