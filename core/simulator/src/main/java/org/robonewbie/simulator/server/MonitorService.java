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
import org.robonewbie.simulator.monitor.MatchEnvironment;
import org.robonewbie.simulator.monitor.MonitorLog;
import org.robonewbie.simulator.monitor.MonitorPort;
import org.robonewbie.simulator.monitor.MonitorSettings;
import org.robonewbie.simulator.monitor.MonitorSnapshot;
import org.robonewbie.simulator.monitor.MonitoredRobotState;
import org.robonewbie.simulator.soccer.Match;
import org.robonewbie.simulator.soccer.MatchState;
import org.robonewbie.simulator.soccer.Player;
import org.robonewbie.simulator.soccer.SoccerParameter;
import org.robonewbie.simulator.soccer.SoccerParameters;

/** Sends the world to monitors, writes the log for them, and receives the commands of trainers. */
final class MonitorService {

    private static final int WAITING_ORDERS = 1000;

    private final SimulationCycle cycle;
    private final Consumer<Runnable> betweenCycles;
    private final TrainerOrders orders;
    private final AtomicInteger waitingOrders = new AtomicInteger();
    private final RateLimitedLogger warnings;
    private Optional<MonitorPort> port = Optional.empty();
    private Optional<MonitorLog> log = Optional.empty();

    /**
     * Prepares the desk; no monitor is served yet.
     *
     * @param cycle what is shown
     * @param betweenCycles runs something on the simulation's thread
     * @param end ends the simulation
     * @param console reports problems
     */
    MonitorService(SimulationCycle cycle, Consumer<Runnable> betweenCycles, Runnable end, Console console) {
        this.warnings = new RateLimitedLogger(console, "A trainer");
        this.cycle = cycle;
        this.betweenCycles = betweenCycles;
        this.orders = new TrainerOrders(cycle, () -> port.ifPresent(MonitorPort::requestFullState), end);
    }

    /** Opens port and log if they are wanted; must be called before the simulation runs. */
    void open(SimulatorSettings settings, Console console) throws IOException {
        MonitorSettings wanted = monitorSettings(settings);
        if (settings.monitorLog().isPresent()) {
            log = Optional.of(MonitorLog.open(settings.monitorLog().get(), wanted, console::say));
        }
        if (settings.monitorPort().isPresent()) {
            Consumer<Order> taker = settings.trainers() ? this::order : this::orderOfSpectator;
            port = Optional.of(MonitorPort.open(wanted, console::say, taker));
        }
    }

    OptionalInt portNumber() {
        return port.map(MonitorPort::number).map(OptionalInt::of).orElse(OptionalInt.empty());
    }

    void cycleEnded() {
        port.ifPresent(monitors -> monitors.cycleEnded(cycle.cycle(), this::snapshot));
        log.ifPresent(lines -> lines.cycleEnded(cycle.cycle(), this::snapshot));
    }

    /** Shows the world to new monitors, and what trainers have changed to all of them, while the clock is stopped. */
    void standsStill() {
        port.filter(monitors -> monitors.monitors() > 0).ifPresent(monitors -> monitors.show(snapshot()));
    }

    void close() {
        port.ifPresent(MonitorPort::close);
        log.ifPresent(MonitorLog::close);
    }

    /** Carries out an order, on the simulation's thread. */
    void execute(Order order) {
        orders.execute(order);
    }

    /** Whoever only watches may ask for the whole scene; all else that changes the world is refused. */
    private void orderOfSpectator(Order order) {
        if (order instanceof Order.RequestFullState) {
            order(order);
        } else {
            warnings.warn(
                    "spectator",
                    "wants to change the world, which this simulator does not allow. Start it without --no-trainers if it is"
                            + " to.");
        }
    }

    /** Takes an order from any thread; a trainer that floods the simulation loses orders. */
    private void order(Order order) {
        if (waitingOrders.incrementAndGet() > WAITING_ORDERS) {
            waitingOrders.decrementAndGet();
            warnings.warn(
                    "flood",
                    "sends more than " + WAITING_ORDERS + " orders in one cycle; what is too much is not carried out.");
            return;
        }
        betweenCycles.accept(() -> {
            waitingOrders.decrementAndGet();
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

    private static MonitorSettings monitorSettings(SimulatorSettings settings) {
        SoccerParameters parameters = settings.world().parameters();
        return new MonitorSettings(
                settings.bindAddress(),
                settings.monitorPort().orElse(0),
                settings.monitorStepSeconds(),
                MatchEnvironment.of(parameters),
                parameters.field(),
                parameters.get(SoccerParameter.BALL_RADIUS));
    }
}
