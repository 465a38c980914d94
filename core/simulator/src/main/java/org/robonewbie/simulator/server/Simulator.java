package org.robonewbie.simulator.server;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.lang.management.ManagementFactory;
import java.lang.management.ThreadMXBean;
import java.util.Optional;
import java.util.OptionalInt;
import org.robonewbie.protocol.frame.AgentLink;
import org.robonewbie.simulator.Console;
import org.robonewbie.simulator.SimulationControl;
import org.robonewbie.simulator.recording.RunReport;

/**
 * A running simulator with its own thread and its agent port.
 *
 * <pre>{@code
 * try (Simulator simulator = Simulator.start(SimulatorSettings.beginner().agentPort(0).build(), Console.standard())) {
 *     simulator.awaitEnd();
 * }
 * }</pre>
 */
public final class Simulator implements AutoCloseable {

    private final Simulation simulation;
    private final AgentPort port;
    private final Thread thread;

    private Simulator(Simulation simulation, AgentPort port, Thread thread) {
        this.simulation = simulation;
        this.port = port;
        this.thread = thread;
    }

    /**
     * Opens the port and starts the simulation.
     *
     * @param settings the configuration
     * @param console prints messages to people
     * @return the running simulator
     * @throws IOException if a port is in use or a file cannot be written; the message says what to do
     */
    public static Simulator start(SimulatorSettings settings, Console console) throws IOException {
        AgentPort port = settings.doors().isEmpty()
                ? AgentPort.open(settings.bindAddress(), settings.agentPort(), console)
                : AgentPort.open(settings.doors(), console);
        Simulation simulation = simulation(settings, port, console);
        Thread thread = new Thread(simulation, "simulation");
        thread.setDaemon(true);
        thread.start();
        return new Simulator(simulation, port, thread);
    }

    /** {@return the TCP port for agents} */
    public int agentPort() {
        return port.number();
    }

    /**
     * Returns the port of a team that has a door of its own.
     *
     * @param team the team
     * @return its TCP port; 0 if its door is a file
     */
    public int agentPort(String team) {
        return port.number(team);
    }

    /**
     * Counts the robots of those who came through a team's own door, whatever they say of themselves. To be asked by an
     * observer, on the simulation's thread.
     *
     * @param team the team
     * @return how many robots it has on the pitch or beside it
     */
    public int robotsOf(String team) {
        return simulation.robotsOf(team);
    }

    /**
     * Looks whether an agent that came through a team's own door was dropped since it kept the world waiting.
     *
     * @param team the team
     * @return whether one was
     */
    public boolean wasSilent(String team) {
        return simulation.wasSilent(team);
    }

    /** {@return the TCP port for monitors; empty if none was wanted} */
    public OptionalInt monitorPort() {
        return simulation.monitors().portNumber();
    }

    /**
     * Connects an agent of this process without a socket. In sync mode the world waits for each of its answers as long as it
     * is connected. Agents are numbered, and served, in the order of these calls.
     *
     * @return the agent's end of the connection
     */
    public AgentLink connect() {
        return simulation.acceptor().connect();
    }

    /** {@return the control of the running simulation; thread-safe} */
    public SimulationControl control() {
        return simulation;
    }

    /** {@return the number of completed cycles of 20 ms} */
    public long cycles() {
        return simulation.cycles();
    }

    /** {@return the number of cycles by which the world fell behind real time so far} */
    public long missedCycles() {
        return simulation.missedCycles();
    }

    /** {@return the number of connected agents, with or without a robot} */
    public int connectedAgents() {
        return simulation.connectedAgents();
    }

    /**
     * {@return seconds of processor time that the simulation's thread has used so far; NaN where the system does not report it}
     */
    public double processorSeconds() {
        ThreadMXBean threads = ManagementFactory.getThreadMXBean();
        return threads.isThreadCpuTimeSupported() ? threads.getThreadCpuTime(thread.getId()) / 1e9 : Double.NaN;
    }

    /** {@return the true results of a simulation that has ended; empty while it runs} */
    public Optional<RunReport> report() {
        return simulation.finalReport();
    }

    /**
     * Waits until the simulation has ended by itself or was closed.
     *
     * @throws InterruptedException if this thread is interrupted
     */
    public void awaitEnd() throws InterruptedException {
        thread.join();
    }

    /**
     * Ends the simulation. Closing twice does nothing.
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
