package org.robonewbie.simulator.server;

import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.function.Consumer;
import org.robonewbie.nao.TeamSide;
import org.robonewbie.protocol.monitor.MonitoredGame;
import org.robonewbie.protocol.order.Order;
import org.robonewbie.protocol.order.PlayerNumber;
import org.robonewbie.simulator.Console;
import org.robonewbie.simulator.cycle.AgentSession;
import org.robonewbie.simulator.cycle.RateLimitedLogger;
import org.robonewbie.simulator.cycle.SimulationCycle;
import org.robonewbie.simulator.cycle.TrainerOrders;
import org.robonewbie.simulator.monitor.MonitorLog;
import org.robonewbie.simulator.monitor.MonitorPort;
import org.robonewbie.simulator.monitor.MonitorSettings;
import org.robonewbie.simulator.monitor.MonitorSnapshot;
import org.robonewbie.simulator.monitor.MonitoredRobotState;
import org.robonewbie.simulator.soccer.Match;
import org.robonewbie.simulator.soccer.MatchState;
import org.robonewbie.simulator.soccer.Player;
import org.robonewbie.simulator.soccer.SoccerParameters;

/** Feeds the monitor port and the monitor log, and executes commands from trainers. */
final class MonitorService {

    private static final int MAX_QUEUED_ORDERS = 1000;

    private final SimulationCycle cycle;
    private final Consumer<Runnable> betweenCycles;
    private final TrainerOrders orders;
    private final AtomicInteger queuedOrders = new AtomicInteger();
    private final RateLimitedLogger warnings;
    private Optional<MonitorPort> port = Optional.empty();
    private Optional<MonitorLog> log = Optional.empty();

    /**
     * Creates the service; {@link #open} starts it.
     *
     * @param betweenCycles runs a task on the simulation thread, between cycles
     * @param end ends the simulation
     */
    MonitorService(SimulationCycle cycle, Consumer<Runnable> betweenCycles, Runnable end, Console console) {
        this.warnings = new RateLimitedLogger(console, "A trainer");
        this.cycle = cycle;
        this.betweenCycles = betweenCycles;
        this.orders = new TrainerOrders(cycle, () -> port.ifPresent(MonitorPort::requestFullState), end);
    }

    /** Opens the configured port and log. Call before the simulation runs. */
    void open(SimulatorSettings settings, Console console) throws IOException {
        SimulatorSettings.Monitors monitors = settings.monitors();
        SoccerParameters parameters = settings.world().parameters();
        if (monitors.log().isPresent()) {
            log = Optional.of(MonitorLog.open(monitors.log().get(), parameters, console::say));
        }
        if (monitors.port().isPresent()) {
            Consumer<Order> receiver = monitors.trainers() ? this::order : this::orderOfSpectator;
            MonitorSettings portSettings = new MonitorSettings(
                    settings.agents().bindAddress(), monitors.port().getAsInt(), monitors.stepSeconds(), parameters);
            port = Optional.of(MonitorPort.open(portSettings, console::say, receiver));
        }
    }

    OptionalInt portNumber() {
        return port.map(MonitorPort::number).map(OptionalInt::of).orElse(OptionalInt.empty());
    }

    void cycleEnded() {
        port.ifPresent(monitors -> monitors.cycleEnded(cycle.cycle(), this::snapshot));
        log.ifPresent(lines -> lines.cycleEnded(cycle.cycle(), this::snapshot));
    }

    /** Sends the state while the clock is paused, for new monitors and after changes by trainers. */
    void idle() {
        port.filter(monitors -> monitors.monitors() > 0).ifPresent(monitors -> monitors.show(snapshot()));
    }

    void close() {
        port.ifPresent(MonitorPort::close);
        log.ifPresent(MonitorLog::close);
    }

    /** Executes a command on the simulation thread. */
    void execute(Order order) {
        orders.execute(order);
    }

    /** Refuses all commands from a view-only monitor, except requests for the full state. */
    private void orderOfSpectator(Order order) {
        if (order instanceof Order.RequestFullState) {
            order(order);
        } else {
            warnings.warn(
                    "spectator",
                    "tried to change the world, which this simulator does not allow. Start the simulator without"
                            + " --no-trainers to allow this.");
        }
    }

    /** Queues a command; excess commands are dropped. Thread-safe. */
    private void order(Order order) {
        if (queuedOrders.incrementAndGet() > MAX_QUEUED_ORDERS) {
            queuedOrders.decrementAndGet();
            warnings.warn(
                    "flood", "sends more than " + MAX_QUEUED_ORDERS + " orders in one cycle; the rest are ignored.");
            return;
        }
        betweenCycles.accept(() -> {
            queuedOrders.decrementAndGet();
            execute(order);
        });
    }

    private MonitorSnapshot snapshot() {
        Optional<Player> selected = orders.selected();
        List<MonitoredRobotState> robots = new ArrayList<>();
        for (AgentSession agent : cycle.agents()) {
            boolean isSelected = agent.player().isPresent() && agent.player().equals(selected);
            agent.robot()
                    .ifPresent(robot -> robots.add(MonitoredRobotState.of(
                            agent.id(), robot, agent.player().map(MonitorService::number), isSelected)));
        }
        return MonitorSnapshot.of(game(cycle.match()), cycle.match().fouls(), cycle.world(), robots);
    }

    private static PlayerNumber number(Player player) {
        return new PlayerNumber(player.side(), player.number());
    }

    private static MonitoredGame game(Match match) {
        MatchState state = match.state();
        return new MonitoredGame(
                state.playSeconds(),
                name(match, TeamSide.LEFT),
                name(match, TeamSide.RIGHT),
                state.half(),
                state.score(TeamSide.LEFT),
                state.score(TeamSide.RIGHT),
                Optional.of(state.playMode()),
                match.scoreWaitSeconds(TeamSide.LEFT),
                match.scoreWaitSeconds(TeamSide.RIGHT));
    }

    private static Optional<String> name(Match match, TeamSide side) {
        return Optional.of(match.teams().name(side)).filter(name -> !name.isEmpty());
    }
}
