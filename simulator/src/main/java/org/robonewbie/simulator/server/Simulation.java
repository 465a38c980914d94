package org.robonewbie.simulator.server;

import java.util.List;
import java.util.Queue;
import java.util.concurrent.ConcurrentLinkedQueue;
import java.util.concurrent.CopyOnWriteArrayList;
import org.robonewbie.nao.PlayMode;
import org.robonewbie.nao.SoccerField;
import org.robonewbie.nao.TeamSide;
import org.robonewbie.nao.Vector3;
import org.robonewbie.simulator.SimulationControl;
import org.robonewbie.simulator.SimulationObserver;
import org.robonewbie.simulator.WorldSnapshot;

/**
 * Runs cycle after cycle on one thread, the only one that touches the world. Other threads leave commands, which are carried
 * out between two cycles.
 */
final class Simulation implements SimulationControl, Runnable {

    private static final long IDLE_MILLISECONDS = 100;
    private static final double SLOWEST = 0.1;

    private final SimulatorSettings settings;
    private final SimulationCycle cycle;
    private final Reception reception;
    private final Pacemaker pacemaker;
    private final SilenceWatch silenceWatch;
    private final RunRecorder recorder;
    private final double lastCycle;
    private final Queue<Runnable> commands = new ConcurrentLinkedQueue<>();
    private final List<SimulationObserver> observers = new CopyOnWriteArrayList<>();
    private boolean paused;
    private int stepsLeft;
    private boolean begun;
    private volatile boolean ending;

    Simulation(SimulatorSettings settings, AgentPort port, Console console, RunRecorder recorder) {
        this.settings = settings;
        this.recorder = recorder;
        this.lastCycle = Math.rint(settings.seconds().orElse(Double.POSITIVE_INFINITY) / WorldSnapshot.CYCLE_SECONDS);
        this.cycle = new SimulationCycle(settings.parameters(), settings.seed(), console, recorder);
        this.reception = new Reception(port, cycle, settings);
        this.pacemaker = new Pacemaker(settings.speed());
        this.silenceWatch = new SilenceWatch(console, settings.silentAgentSeconds());
    }

    Reception reception() {
        return reception;
    }

    SimulationCycle cycle() {
        return cycle;
    }

    long missedCycles() {
        return pacemaker.missedCycles();
    }

    /** Lets the simulation end after the present cycle, from any thread. */
    void end() {
        ending = true;
        reception.ring();
    }

    @Override
    public void run() {
        while (!ending) {
            turn();
        }
        for (ConnectedAgent agent : cycle.agents()) {
            agent.connection().link().close();
        }
        reception.close();
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

    private void carryOutCommands() {
        for (Runnable command = commands.poll(); command != null; command = commands.poll()) {
            command.run();
        }
    }

    private boolean isReady() {
        if (!begun && cycle.heardAgents() < settings.awaitedAgents()) {
            return false;
        }
        return !settings.synchronous() || cycle.unsynchronisedAgent().isEmpty();
    }

    private void runCycle() {
        begun = true;
        cycle.run();
        stepsLeft = Math.max(0, stepsLeft - 1);
        recorder.cycleEnded(cycle);
        report();
        if (cycle.cycle() >= lastCycle || cycle.match().isProgramOver()) {
            ending = true;
        } else {
            pacemaker.awaitNextCycle();
        }
    }

    private void standStill() {
        pacemaker.excuse();
        if (!reception.await(IDLE_MILLISECONDS)) {
            report();
        }
    }

    private void report() {
        if (!observers.isEmpty()) {
            WorldSnapshot snapshot = Snapshots.of(cycle, paused, pacemaker);
            for (SimulationObserver observer : observers) {
                observer.cycleEnded(snapshot);
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
        command(() -> cycle.match()
                .teams()
                .player(side, number)
                .ifPresent(player -> player.robot().moveUpright(position, headingDegrees - 90)));
    }

    @Override
    public void kickOff(TeamSide side) {
        command(() -> cycle.match().kickOff(side));
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
    public void addObserver(SimulationObserver observer) {
        observers.add(observer);
    }

    @Override
    public void removeObserver(SimulationObserver observer) {
        observers.remove(observer);
    }
}
