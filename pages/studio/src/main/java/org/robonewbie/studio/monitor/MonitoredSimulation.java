package org.robonewbie.studio.monitor;

import java.io.IOException;
import java.util.List;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.locks.LockSupport;
import org.robonewbie.nao.PlayMode;
import org.robonewbie.nao.SoccerField;
import org.robonewbie.nao.Vector3;
import org.robonewbie.protocol.monitor.MonitoredGame;
import org.robonewbie.protocol.monitor.MonitoredWorld;
import org.robonewbie.protocol.order.Order;
import org.robonewbie.protocol.tcp.MonitorLink;
import org.robonewbie.simulator.SimulationControl;
import org.robonewbie.simulator.SimulationObserver;
import org.robonewbie.simulator.WorldSnapshot;
import org.robonewbie.simulator.soccer.MatchEvent;

/**
 * A remote simulation, watched and controlled through the monitor port of a SimSpark server (protocol: SimSpark's
 * {@code sparkmonitor.cpp} and {@code trainercommandparser.cpp}). Reconnects when the server is restarted.
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
    private static final long RETRY_NANOS = TimeUnit.SECONDS.toNanos(1);

    private final String host;
    private final int port;
    private final List<SimulationObserver> observers = new CopyOnWriteArrayList<>();
    private final Thread thread = new Thread(this::listen, "studio-monitor");
    private final MonitorClock clock = new MonitorClock();
    private volatile MonitorLink link;
    private volatile SoccerField field = SoccerField.LEAGUE;
    private volatile boolean open = true;
    private MonitoredGame lastGame = MonitoredGame.UNKNOWN;

    private MonitoredSimulation(String host, int port, MonitorLink link) {
        this.host = host;
        this.port = port;
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
        MonitoredSimulation simulation = new MonitoredSimulation(host, port, MonitorLink.connect(host, port));
        simulation.thread.start();
        return simulation;
    }

    private void listen() {
        while (open) {
            try {
                while (link.receive()) {
                    take(link.world());
                }
            } catch (IOException lost) {
                // The server has stopped; reconnect below.
            }
            link.close();
            seekAgain();
        }
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
        if (!world.isCurrent()) {
            link.send(new Order.RequestFullState());
            return;
        }
        field = MonitorSnapshots.field(world.environment());
        clock.tick(world.gameState());
        reportEvents(world);
        WorldSnapshot snapshot =
                MonitorSnapshots.of(world, clock.cycle(), clock.realTimeFactor(), clock.isStandingStill());
        observers.forEach(observer -> observer.cycleEnded(snapshot));
    }

    private void reportEvents(MonitoredWorld world) {
        world.newFouls().forEach(foul -> report(MonitorEvents.of(foul)));
        MonitorEvents.between(lastGame, world.gameState()).forEach(this::report);
        lastGame = world.gameState();
    }

    private void report(MatchEvent event) {
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
    public boolean hasClock() {
        return false;
    }

    @Override
    public void order(Order order) {
        if (order instanceof Order.Clock) {
            throw new UnsupportedOperationException(NO_CLOCK);
        } else if (order instanceof Order.Trainer known) {
            send(known);
        } else if (order instanceof Order.PlaceRobot place) {
            send(new Order.MoveAndTurnRobot(place.player(), place.position(), place.headingDegrees() - 90));
        } else if (order instanceof Order.Reset) {
            reset();
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

    @Override
    public void addObserver(SimulationObserver observer) {
        observers.add(observer);
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
    }
}
