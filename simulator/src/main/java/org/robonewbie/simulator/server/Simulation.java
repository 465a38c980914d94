package org.robonewbie.simulator.server;

import java.io.IOException;
import java.io.PrintWriter;
import java.io.StringWriter;
import java.util.List;
import java.util.Optional;
import java.util.Queue;
import java.util.concurrent.ConcurrentLinkedQueue;
import java.util.concurrent.CopyOnWriteArrayList;
import org.robonewbie.nao.PlayMode;
import org.robonewbie.nao.SoccerField;
import org.robonewbie.nao.TeamSide;
import org.robonewbie.nao.Vector3;
import org.robonewbie.protocol.frame.AgentLink;
import org.robonewbie.simulator.AgentMessages;
import org.robonewbie.simulator.SimulationControl;
import org.robonewbie.simulator.SimulationObserver;
import org.robonewbie.simulator.WorldSnapshot;
import org.robonewbie.simulator.recording.RunReport;
import org.robonewbie.simulator.soccer.MatchEvent;

/**
 * Runs cycle after cycle on one thread, the only one that touches the world. Other threads leave commands, which are carried
 * out between two cycles.
 */
final class Simulation implements SimulationControl, Runnable {

    private static final long IDLE_MILLISECONDS = 100;
    private static final double SLOWEST = 0.1;

    private final SimulatorSettings settings;
    private final Console console;
    private final SimulationCycle cycle;
    private final Reception reception;
    private final Pacemaker pacemaker;
    private final SilenceWatch silenceWatch;
    private final MonitorDesk monitors;
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
        this.console = console;
        this.lastCycle = Math.rint(settings.seconds().orElse(Double.POSITIVE_INFINITY) / WorldSnapshot.CYCLE_SECONDS);
        this.cycle = SimulationCycle.begin(settings, console);
        this.cycle.reportEventsTo(this::happened);
        this.reception = new Reception(port, cycle, settings);
        this.pacemaker = new Pacemaker(settings.speed());
        this.silenceWatch = new SilenceWatch(console, settings.silentAgentSeconds());
        this.monitors = new MonitorDesk(cycle, this::command, this::end, console);
    }

    Reception reception() {
        return reception;
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

    MonitorDesk monitors() {
        return monitors;
    }

    /** Tells how many cycles are over, to any thread. */
    long cycles() {
        return cycles;
    }

    /** Tells how many agents are connected, to any thread. */
    int connectedAgents() {
        return connectedAgents;
    }

    /** Tells how many cycles real time had and the world had not, to any thread. */
    long missedCycles() {
        return missedCycles;
    }

    /** Gives the true results once the simulation has ended. */
    Optional<RunReport> finalReport() {
        return finalReport;
    }

    /** Tells why the report could not be written. */
    Optional<IOException> reportFailure() {
        return reportFailure;
    }

    /** Lets the simulation end after the present cycle, from any thread. */
    void end() {
        closing = true;
        reception.ring();
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

    /** Tells whether nothing is left to do: the last messages of agents that have ended still count, unless paused. */
    private boolean isFinished() {
        reception.receive();
        return (paused && stepsLeft == 0)
                || !settings.synchronous()
                || settings.awaitedAgents() == 0
                || cycle.isAnybodyConnected()
                || !isReady();
    }

    private void finish() {
        for (ConnectedAgent agent : cycle.agents()) {
            agent.connection().link().close();
        }
        reception.close();
        monitors.close();
        double wallSeconds = begun ? (System.nanoTime() - beginning) / 1e9 : 0;
        RunReport result = cycle.recorder().report(settings.seed(), wallSeconds, pacemaker.missedCycles());
        finalReport = Optional.of(result);
        cycle.recorder().close();
        if (settings.report().isPresent()) {
            try {
                result.write(settings.report().get());
            } catch (IOException e) {
                reportFailure = Optional.of(e);
                console.say(String.valueOf(e.getMessage()));
            }
        }
    }

    private void turn() {
        carryOutCommands();
        reception.receive();
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

    /** Carries out what is there now; whoever goes on sending must not keep the world from going on. */
    private void carryOutCommands() {
        for (int count = commands.size(); count > 0; count--) {
            commands.remove().run();
        }
    }

    /** Tells whether everybody is there for whom the world waits. */
    private boolean isReady() {
        int awaited =
                begun && settings.synchronous() ? Math.min(1, settings.awaitedAgents()) : settings.awaitedAgents();
        if ((!begun || settings.synchronous()) && cycle.heardAgents() < awaited) {
            return false;
        }
        return !settings.synchronous() || cycle.unsynchronisedAgent().isEmpty();
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
        if (!reception.await(IDLE_MILLISECONDS)) {
            report();
            monitors.standsStill();
        }
    }

    private void report() {
        if (!observers.isEmpty()) {
            WorldSnapshot snapshot = Snapshots.of(cycle, paused, pacemaker);
            for (SimulationObserver observer : observers) {
                tellMessages(observer);
                observer.cycleEnded(snapshot);
            }
        }
    }

    private void tellMessages(SimulationObserver observer) {
        for (ConnectedAgent agent : cycle.agents()) {
            if (agent.robot().isPresent() && observer.wantsMessagesOf(agent.id())) {
                String perceptors = agent.connection().newestMessage().toString();
                String effectors = agent.connection().executedMessage().toString();
                observer.messagesExchanged(new AgentMessages(agent.id(), cycle.cycle(), perceptors, effectors));
            }
        }
    }

    private void command(Runnable command) {
        commands.add(command);
        reception.ring();
    }

    @Override
    public SoccerField field() {
        return settings.parameters().field();
    }

    @Override
    public void pause() {
        command(() -> {
            paused = true;
            stepsLeft = 0;
        });
    }

    @Override
    public void resume() {
        command(() -> paused = false);
    }

    @Override
    public void step(int cycles) {
        command(() -> {
            paused = true;
            stepsLeft += cycles;
        });
    }

    @Override
    public void setSpeed(double factor) {
        command(() -> pacemaker.setSpeed(Math.max(SLOWEST, factor)));
    }

    @Override
    public void reset() {
        command(cycle::reset);
    }

    @Override
    public void placeBall(Vector3 position, Vector3 velocity) {
        command(() -> cycle.placeBall(position, velocity));
    }

    @Override
    public void placeRobot(TeamSide side, int number, Vector3 position, double headingDegrees) {
        command(() -> cycle.match().teams().player(side, number).ifPresent(player -> {
            player.robot().moveUpright(position, headingDegrees - 90);
            player.robot().wake();
        }));
    }

    @Override
    public void pushRobot(TeamSide side, int number, Vector3 newtons) {
        command(() -> cycle.match()
                .teams()
                .player(side, number)
                .ifPresent(player -> player.robot().push(newtons)));
    }

    @Override
    public void kickOff(TeamSide side) {
        command(() -> cycle.kickOff(side));
    }

    @Override
    public void dropBall() {
        command(() -> cycle.match().dropBall());
    }

    @Override
    public void setPlayMode(PlayMode playMode) {
        command(() -> cycle.match().setPlayMode(playMode));
    }

    @Override
    public void restore(WorldSnapshot before, WorldSnapshot moment) {
        command(() -> new Restoration(cycle).restore(before, moment));
    }

    @Override
    public Optional<AgentLink> connect() {
        return Optional.of(reception.connect());
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
