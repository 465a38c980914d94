package org.robonewbie.simulator.server;

import java.io.IOException;
import java.io.PrintWriter;
import java.io.StringWriter;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.Queue;
import java.util.concurrent.ConcurrentLinkedQueue;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.TimeUnit;
import java.util.function.Consumer;
import java.util.function.Supplier;
import org.robonewbie.nao.Cycle;
import org.robonewbie.nao.SoccerField;
import org.robonewbie.nao.file.AtomicFile;
import org.robonewbie.nao.math.PortableMath;
import org.robonewbie.protocol.frame.AgentLink;
import org.robonewbie.protocol.order.Order;
import org.robonewbie.simulator.Console;
import org.robonewbie.simulator.SimulationControl;
import org.robonewbie.simulator.SimulationObserver;
import org.robonewbie.simulator.WorldSnapshot;
import org.robonewbie.simulator.cycle.SimulationCycle;
import org.robonewbie.simulator.file.RecordingFile;
import org.robonewbie.simulator.recording.RunReport;
import org.robonewbie.simulator.state.WorldState;

/**
 * The main loop of a simulator. Only the simulation thread accesses the world; other threads queue commands, which it
 * executes between cycles.
 */
final class Simulation implements SimulationControl, Runnable {

    private static final long IDLE_MILLISECONDS = 100;
    private static final long ANSWER_TIMEOUT_NANOS = TimeUnit.SECONDS.toNanos(2);
    private static final double MIN_SPEED = 0.1;

    private final SimulatorSettings settings;
    private final AgentPort port;
    private final Console console;
    private final SimulationCycle cycle;
    private final AgentAcceptor acceptor;
    private final Pacemaker pacemaker;
    private final StalledAgentWatch stalledAgents;
    private final MonitorService monitors;
    private final double lastCycle;
    private final Queue<Runnable> commands = new ConcurrentLinkedQueue<>();
    private final List<SimulationObserver> observers = new CopyOnWriteArrayList<>();
    private boolean paused;
    private int stepsLeft;
    private boolean begun;
    private long beginning;
    private boolean over;
    private volatile long cycles;
    private volatile long missedCycles;
    private volatile int connectedAgents;
    private volatile boolean closing;
    private volatile Optional<RunReport> finalReport = Optional.empty();
    private volatile Optional<IOException> reportFailure = Optional.empty();

    Simulation(SimulatorSettings settings, AgentPort port, Console console) throws IOException {
        this.settings = settings;
        this.port = port;
        this.console = sentence -> {
            console.say(sentence);
            observers.forEach(observer -> observer.messagePrinted(sentence));
        };
        this.lastCycle = PortableMath.rint(settings.seconds() / Cycle.SECONDS);
        this.cycle = new SimulationCycle(
                settings.world(),
                RecordingFile.openIfWanted(settings.output().recording(), console::say),
                this.console,
                console);
        this.cycle.reportEventsTo(event -> observers.forEach(observer -> observer.happened(event)));
        this.acceptor = new AgentAcceptor(port, cycle, settings);
        this.pacemaker = new Pacemaker(settings.speed());
        this.stalledAgents =
                new StalledAgentWatch(this.console, settings.agents().silentSeconds());
        this.monitors = new MonitorService(cycle, this::command, this::end, this.console);
    }

    AgentAcceptor acceptor() {
        return acceptor;
    }

    SimulationCycle cycle() {
        return cycle;
    }

    /** Opens the port and the log for monitors. Call before the simulation runs. */
    void openMonitors() throws IOException {
        try {
            monitors.open(settings, console);
        } catch (IOException e) {
            monitors.close();
            cycle.recorder().close();
            throw e;
        }
    }

    MonitorService monitors() {
        return monitors;
    }

    long cycles() {
        return cycles;
    }

    int connectedAgents() {
        return connectedAgents;
    }

    int robotsOf(String team) {
        return (int) cycle.agents().stream()
                .filter(agent -> agent.robot().isPresent())
                .filter(agent ->
                        agent.connection().link().team().filter(team::equals).isPresent())
                .count();
    }

    boolean wasSilent(String team) {
        return stalledAgents.silentTeams().contains(team);
    }

    long missedCycles() {
        return missedCycles;
    }

    Optional<RunReport> finalReport() {
        return finalReport;
    }

    Optional<IOException> reportFailure() {
        return reportFailure;
    }

    /** Ends the simulation after the current cycle. Thread-safe. */
    void end() {
        closing = true;
        acceptor.wakeUp();
    }

    @Override
    public void run() {
        try {
            while (!over && !(closing && isFinished())) {
                advance();
            }
        } catch (RuntimeException | OutOfMemoryError e) {
            StringWriter trace = new StringWriter();
            e.printStackTrace(new PrintWriter(trace));
            console.say("The simulation has failed; please report this. " + trace);
        } finally {
            finish();
        }
    }

    /**
     * Returns whether a closing simulation may end. Unless it is paused, the last messages of agents that have left are
     * executed first.
     */
    private boolean isFinished() {
        acceptor.receiveAll();
        return (paused && stepsLeft == 0)
                || !settings.world().synchronous()
                || settings.agents().awaited() == 0
                || cycle.hasConnectedAgent()
                || cycle.world().robots().isEmpty()
                || !isReady();
    }

    private void finish() {
        cycle.closeConnections();
        acceptor.close();
        monitors.close();
        double wallSeconds = begun ? (System.nanoTime() - beginning) / 1e9 : 0;
        RunReport result = cycle.recorder().report(settings.world().seed(), wallSeconds, pacemaker.missedCycles());
        finalReport = Optional.of(result);
        cycle.recorder().close();
        Optional<Path> reportFile = settings.output().report();
        if (reportFile.isPresent()) {
            try {
                AtomicFile.write(reportFile.get(), result.toJson());
            } catch (IOException e) {
                reportFailure = Optional.of(e);
                console.say(String.valueOf(e.getMessage()));
            }
        }
    }

    /** Runs one cycle if all agents are ready; otherwise waits. */
    private void advance() {
        executeCommands();
        acceptor.receive();
        if (paused && stepsLeft == 0) {
            stalledAgents.reset();
            idle();
        } else if (isReady()) {
            stalledAgents.reset();
            runCycle();
        } else {
            cycle.unsynchronisedAgent().ifPresent(stalledAgents::check);
            idle();
        }
    }

    /**
     * Executes the commands queued so far, but none that are added meanwhile, so that a busy client cannot block the
     * simulation.
     */
    private void executeCommands() {
        for (int count = commands.size(); count > 0; count--) {
            commands.remove().run();
        }
    }

    /** Returns whether the awaited agents are connected and, in sync mode, all agents have answered. */
    private boolean isReady() {
        int awaited = settings.agents().awaited();
        if (begun) {
            awaited = settings.world().synchronous() ? Math.min(1, awaited) : 0;
        }
        return (awaited == 0 || speakingAgents() >= awaited) && isAnswered();
    }

    /** Counts the agents that have sent a message, excluding those beyond the limit of a team endpoint. */
    private long speakingAgents() {
        long count = cycle.speakingAgents(Optional.empty());
        for (TeamEndpoint endpoint : settings.agents().endpoints()) {
            count += Math.min(endpoint.robots(), cycle.speakingAgents(Optional.of(endpoint.team())));
        }
        return count;
    }

    private boolean isAnswered() {
        return !settings.world().synchronous() || cycle.unsynchronisedAgent().isEmpty();
    }

    private void runCycle() {
        if (!begun) {
            begun = true;
            beginning = System.nanoTime();
        }
        cycle.run();
        cycles = cycle.cycle();
        missedCycles = pacemaker.missedCycles();
        connectedAgents = cycle.agents().size();
        stepsLeft = Math.max(0, stepsLeft - 1);
        monitors.cycleEnded();
        report();
        if (cycle.cycle() >= lastCycle || cycle.match().isProgramOver()) {
            over = true;
        } else {
            pacemaker.awaitNextCycle();
        }
    }

    private void idle() {
        pacemaker.pause();
        if (!acceptor.await(IDLE_MILLISECONDS)) {
            report();
            monitors.idle();
        }
    }

    private void report() {
        List<SimulationObserver> interested =
                observers.stream().filter(SimulationObserver::wantsSnapshot).toList();
        if (!interested.isEmpty()) {
            WorldSnapshot snapshot = cycle.snapshot(paused, pacemaker.speed(), pacemaker.realTimeFactor());
            for (SimulationObserver observer : interested) {
                cycle.messages(observer::wantsMessagesOf).forEach(observer::messagesExchanged);
                observer.cycleEnded(snapshot);
            }
        }
    }

    private void command(Runnable command) {
        commands.add(command);
        acceptor.wakeUp();
    }

    @Override
    public SoccerField field() {
        return settings.world().parameters().field();
    }

    @Override
    public void order(Order order) {
        command(() -> execute(order));
    }

    private void execute(Order order) {
        if (order instanceof Order.Pause) {
            pauseAfter(0);
        } else if (order instanceof Order.Resume) {
            paused = false;
        } else if (order instanceof Order.Step step) {
            pauseAfter(stepsLeft + step.cycles());
        } else if (order instanceof Order.SetSpeed set) {
            pacemaker.setSpeed(Math.max(MIN_SPEED, set.factor()));
        } else {
            monitors.execute(order);
        }
    }

    private void pauseAfter(int cycles) {
        paused = true;
        stepsLeft = cycles;
    }

    @Override
    public void restore(WorldSnapshot before, WorldSnapshot target) {
        command(() -> cycle.restore(before, target));
    }

    @Override
    public void save(Consumer<Optional<WorldState>> receiver) {
        actWhenAnswered(cycle::save, receiver);
    }

    @Override
    public void restore(WorldState state, Consumer<OptionalInt> receiver) {
        actWhenAnswered(
                () -> cycle.resumeFrom(state),
                restored -> receiver.accept(restored.map(OptionalInt::of).orElse(OptionalInt.empty())));
    }

    private <T> void actWhenAnswered(Supplier<T> action, Consumer<Optional<T>> receiver) {
        long end = System.nanoTime() + ANSWER_TIMEOUT_NANOS;
        command(() -> actIfAnswered(action, receiver, end));
    }

    /**
     * Performs the action once all agents have answered, retrying until the timeout, because an agent that is computing
     * its answer cannot be saved.
     */
    private <T> void actIfAnswered(Supplier<T> action, Consumer<Optional<T>> receiver, long end) {
        acceptor.receive();
        if (isAnswered()) {
            receiver.accept(result(action));
        } else if (System.nanoTime() - end > 0) {
            receiver.accept(Optional.empty());
        } else {
            commands.add(() -> actIfAnswered(action, receiver, end));
        }
    }

    private static <T> Optional<T> result(Supplier<T> action) {
        try {
            return Optional.of(action.get());
        } catch (IllegalArgumentException | UnsupportedOperationException refused) {
            return Optional.empty();
        }
    }

    @Override
    public OptionalInt agentPort() {
        int number = port.number(Optional.empty());
        return number > 0 ? OptionalInt.of(number) : OptionalInt.empty();
    }

    @Override
    public Optional<AgentLink> connect() {
        return Optional.of(acceptor.connect());
    }

    @Override
    public void addObserver(SimulationObserver observer) {
        observers.add(observer);
    }

    @Override
    public void removeObserver(SimulationObserver observer) {
        observers.remove(observer);
    }
}
