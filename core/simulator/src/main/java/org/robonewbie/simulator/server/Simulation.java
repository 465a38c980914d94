package org.robonewbie.simulator.server;

import java.io.IOException;
import java.io.PrintWriter;
import java.io.StringWriter;
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
import org.robonewbie.nao.math.PortableMath;
import org.robonewbie.protocol.frame.AgentLink;
import org.robonewbie.protocol.order.Order;
import org.robonewbie.simulator.Console;
import org.robonewbie.simulator.SimulationControl;
import org.robonewbie.simulator.SimulationObserver;
import org.robonewbie.simulator.WorldSnapshot;
import org.robonewbie.simulator.cycle.SimulationCycle;
import org.robonewbie.simulator.file.RecordingFile;
import org.robonewbie.simulator.file.ReportFile;
import org.robonewbie.simulator.recording.RunReport;
import org.robonewbie.simulator.soccer.MatchEvent;
import org.robonewbie.simulator.state.WorldState;

/**
 * Runs cycle after cycle on one thread, the only one that touches the world. Other threads leave commands, which are carried
 * out between two cycles.
 */
final class Simulation implements SimulationControl, Runnable {

    private static final long IDLE_MILLISECONDS = 100;
    private static final long PATIENCE_NANOS = TimeUnit.SECONDS.toNanos(2);
    private static final double SLOWEST = 0.1;

    private final SimulatorSettings settings;
    private final Console console;
    private final SimulationCycle cycle;
    private final AgentAcceptor acceptor;
    private final Pacemaker pacemaker;
    private final StalledAgentWatch silenceWatch;
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

    /**
     * Prepares a simulation.
     *
     * @throws IOException if the recording cannot be written; the message says what to do
     */
    Simulation(SimulatorSettings settings, AgentPort port, Console console) throws IOException {
        this.settings = settings;
        this.console = sentence -> {
            console.say(sentence);
            observers.forEach(observer -> observer.told(sentence));
        };
        this.lastCycle = PortableMath.rint(settings.seconds().orElse(Double.POSITIVE_INFINITY) / Cycle.SECONDS);
        this.cycle = new SimulationCycle(
                settings.world(), RecordingFile.openIfWanted(settings.recording(), console::say), this.console);
        this.cycle.reportEventsTo(this::happened);
        this.acceptor = new AgentAcceptor(port, cycle, settings);
        this.pacemaker = new Pacemaker(settings.speed(), RealTime.CLOCK);
        this.silenceWatch = new StalledAgentWatch(this.console, settings.silentAgentSeconds());
        this.monitors = new MonitorService(cycle, this::command, this::end, this.console);
    }

    AgentAcceptor acceptor() {
        return acceptor;
    }

    SimulationCycle cycle() {
        return cycle;
    }

    /**
     * Opens what monitors need; to be called before the simulation runs.
     *
     * @throws IOException if port or log cannot be opened; the message says what to do
     */
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

    /** The number of completed cycles; may be called from any thread. */
    long cycles() {
        return cycles;
    }

    /** The number of connected agents; may be called from any thread. */
    int connectedAgents() {
        return connectedAgents;
    }

    /** The robots of those who came through a team's own door, playing or not; on the simulation's thread. */
    int robotsOf(String team) {
        return (int) cycle.agents().stream()
                .filter(agent -> agent.robot().isPresent())
                .filter(agent ->
                        agent.connection().link().team().filter(team::equals).isPresent())
                .count();
    }

    /** Whether a team with a door of its own has kept the world waiting; may be called from any thread. */
    boolean wasSilent(String team) {
        return silenceWatch.silentTeams().contains(team);
    }

    /** The number of cycles by which the world fell behind real time; may be called from any thread. */
    long missedCycles() {
        return missedCycles;
    }

    /** The true results, once the simulation has ended. */
    Optional<RunReport> finalReport() {
        return finalReport;
    }

    /** Why the report could not be written. */
    Optional<IOException> reportFailure() {
        return reportFailure;
    }

    /** Ends the simulation after the present cycle; may be called from any thread. */
    void end() {
        closing = true;
        acceptor.ring();
    }

    @Override
    public void run() {
        try {
            while (!over && !(closing && isFinished())) {
                turn();
            }
        } catch (RuntimeException | OutOfMemoryError e) {
            StringWriter trace = new StringWriter();
            e.printStackTrace(new PrintWriter(trace));
            console.say("The simulation has failed; please report this. " + trace);
        } finally {
            finish();
        }
    }

    /** Whether nothing is left to do: the last messages of agents that have ended still count, unless paused. */
    private boolean isFinished() {
        acceptor.receiveAll();
        return (paused && stepsLeft == 0)
                || !settings.world().synchronous()
                || settings.awaitedAgents() == 0
                || cycle.isAnybodyConnected()
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
        if (settings.report().isPresent()) {
            try {
                ReportFile.write(result, settings.report().get());
            } catch (IOException e) {
                reportFailure = Optional.of(e);
                console.say(String.valueOf(e.getMessage()));
            }
        }
    }

    private void turn() {
        executeCommands();
        acceptor.receive();
        if (paused && stepsLeft == 0) {
            silenceWatch.everybodyAnswered();
            standStill();
        } else if (isReady()) {
            silenceWatch.everybodyAnswered();
            runCycle();
        } else {
            cycle.unsynchronisedAgent().ifPresent(silenceWatch::isWaitingFor);
            standStill();
        }
    }

    /** Executes the commands that are there now; a client that keeps sending must not keep the world from continuing. */
    private void executeCommands() {
        for (int count = commands.size(); count > 0; count--) {
            commands.remove().run();
        }
    }

    /** Whether all awaited agents are there. */
    private boolean isReady() {
        int awaited = begun && settings.world().synchronous()
                ? Math.min(1, settings.awaitedAgents())
                : settings.awaitedAgents();
        if ((!begun || settings.world().synchronous()) && heardAgents() < awaited) {
            return false;
        }
        return isAnswered();
    }

    /** Those of whom something was heard; a team with a door of its own cannot stand in for another one. */
    private long heardAgents() {
        long heard = cycle.heardAgents(Optional.empty());
        for (TeamDoor door : settings.doors()) {
            heard += Math.min(door.robots(), cycle.heardAgents(Optional.of(door.team())));
        }
        return heard;
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

    private void happened(MatchEvent event) {
        observers.forEach(observer -> observer.happened(event));
    }

    private void standStill() {
        pacemaker.excuse();
        if (!acceptor.await(IDLE_MILLISECONDS)) {
            report();
            monitors.standsStill();
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
        acceptor.ring();
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
            hold(0);
        } else if (order instanceof Order.Resume) {
            paused = false;
        } else if (order instanceof Order.Step step) {
            hold(stepsLeft + step.cycles());
        } else if (order instanceof Order.SetSpeed set) {
            pacemaker.setSpeed(Math.max(SLOWEST, set.factor()));
        } else {
            monitors.execute(order);
        }
    }

    /** Stops the clock after some more cycles. */
    private void hold(int cycles) {
        paused = true;
        stepsLeft = cycles;
    }

    @Override
    public void restore(WorldSnapshot before, WorldSnapshot moment) {
        command(() -> cycle.restore(before, moment));
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
        long end = System.nanoTime() + PATIENCE_NANOS;
        command(() -> actIfAnswered(action, receiver, end));
    }

    /** Tries again before the next cycle while answers are missing, since an agent that is thinking is out of reach. */
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
        int number = acceptor.portNumber();
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
