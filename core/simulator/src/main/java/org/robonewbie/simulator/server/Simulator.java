package org.robonewbie.simulator.server;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.lang.management.ManagementFactory;
import java.lang.management.ThreadMXBean;
import java.util.Optional;
import java.util.OptionalInt;
import org.robonewbie.protocol.frame.AgentLink;
import org.robonewbie.simulator.Console;
import org.robonewbie.simulator.JoinableSimulator;
import org.robonewbie.simulator.SimulationControl;
import org.robonewbie.simulator.recording.RunReport;

/**
 * A running simulator with a thread and ports for agents and monitors.
 *
 * <pre>{@code
 * WorldSettings world = WorldSettings.beginner().withSynchronous(false);
 * SimulatorSettings settings = SimulatorSettings.of(world).withAgentPort(0);
 * try (Simulator simulator = Simulator.start(settings, Console.standard())) {
 *     simulator.awaitEnd();
 * }
 * }</pre>
 */
public final class Simulator implements JoinableSimulator {

    private final Simulation simulation;
    private final AgentPort port;
    private final Thread thread;

    private Simulator(Simulation simulation, AgentPort port, Thread thread) {
        this.simulation = simulation;
        this.port = port;
        this.thread = thread;
    }

    /**
     * Opens the ports and starts the simulation.
     *
     * @param settings the configuration
     * @param console output for messages to the user
     * @return the running simulator
     * @throws IOException if a port is in use or a file cannot be written; the message says what to do
     */
    public static Simulator start(SimulatorSettings settings, Console console) throws IOException {
        AgentPort port = AgentPort.open(settings.agents(), console);
        Simulation simulation = simulation(settings, port, console);
        Thread thread = new Thread(simulation, "simulation");
        thread.setDaemon(true);
        thread.start();
        return new Simulator(simulation, port, thread);
    }

    /** {@return the TCP port for agents; 0 if there are team endpoints instead} */
    @Override
    public int agentPort() {
        return port.number(Optional.empty());
    }

    /**
     * Returns the TCP port of a team's endpoint.
     *
     * @param team the team
     * @return its TCP port; 0 for a Unix domain socket
     */
    public int agentPort(String team) {
        return port.number(Optional.of(team));
    }

    /**
     * Counts the robots whose agents connected through a team's endpoint. Call this from an observer, on the simulation
     * thread.
     *
     * @param team the team
     * @return the number of robots on the pitch or beside it
     */
    public int robotsOf(String team) {
        return simulation.robotsOf(team);
    }

    /**
     * Returns whether an agent that connected through a team's endpoint was disconnected because it blocked sync mode.
     *
     * @param team the team
     * @return whether any agent was disconnected
     */
    public boolean wasSilent(String team) {
        return simulation.wasSilent(team);
    }

    /** {@return the TCP port for monitors; empty if there is none} */
    public OptionalInt monitorPort() {
        return simulation.monitors().portNumber();
    }

    /**
     * Connects an in-process agent without a socket. While it is connected, sync mode waits for each of its answers. Agents are
     * numbered and served in the order of these calls.
     *
     * @return the agent's end of the connection
     */
    @Override
    public AgentLink connect() {
        return simulation.acceptor().connect();
    }

    /** {@return the thread-safe control of the simulation} */
    @Override
    public SimulationControl control() {
        return simulation;
    }

    /** {@return the number of completed cycles of 20 ms} */
    public long cycles() {
        return simulation.cycles();
    }

    /** {@return the number of cycles by which the simulation has fallen behind real time} */
    public long missedCycles() {
        return simulation.missedCycles();
    }

    /** {@return the number of connected agents, with or without a robot} */
    public int connectedAgents() {
        return simulation.connectedAgents();
    }

    /**
     * {@return CPU seconds used by the simulation thread; NaN if the JVM cannot measure them}
     */
    public double processorSeconds() {
        ThreadMXBean threads = ManagementFactory.getThreadMXBean();
        return threads.isThreadCpuTimeSupported() ? threads.getThreadCpuTime(thread.getId()) / 1e9 : Double.NaN;
    }

    /** {@return the results of a simulation that has ended; empty while it runs} */
    public Optional<RunReport> report() {
        return simulation.finalReport();
    }

    /**
     * Waits until the simulation ends or is closed.
     *
     * @throws InterruptedException if this thread is interrupted
     */
    @Override
    public void awaitEnd() throws InterruptedException {
        thread.join();
    }

    /**
     * Ends the simulation. Has no effect on a closed simulator.
     *
     * @throws UncheckedIOException if the report cannot be written
     */
    @Override
    public void close() {
        simulation.end();
        try {
            thread.join();
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        }
        if (simulation.reportFailure().isPresent()) {
            throw new UncheckedIOException(simulation.reportFailure().get());
        }
    }

    private static Simulation simulation(SimulatorSettings settings, AgentPort port, Console console)
            throws IOException {
        try {
            Simulation simulation = new Simulation(settings, port, console);
            simulation.openMonitors();
            return simulation;
        } catch (IOException e) {
            port.close();
            throw e;
        }
    }
}
