package org.robonewbie.simulator.server;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.lang.management.ManagementFactory;
import java.lang.management.ThreadMXBean;
import java.util.Optional;
import java.util.OptionalInt;
import org.robonewbie.protocol.frame.AgentLink;
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
     * @param settings what the simulator shall do
     * @param console where it tells people what happens
     * @return the running simulator
     * @throws IOException if a port is in use or a file cannot be written; the message says what to do
     */
    public static Simulator start(SimulatorSettings settings, Console console) throws IOException {
        AgentPort port = AgentPort.open(settings.bindAddress(), settings.agentPort(), console);
        Simulation simulation = simulation(settings, port, console);
        Thread thread = new Thread(simulation, "simulation");
        thread.setDaemon(true);
        thread.start();
        return new Simulator(simulation, port, thread);
    }

    /**
     * Tells where agents can connect.
     *
     * @return the TCP port
     */
    public int agentPort() {
        return port.number();
    }

    /**
     * Tells where monitors can connect.
     *
     * @return the TCP port, or empty if none was wanted
     */
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
        return simulation.reception().connect();
    }

    /**
     * Gives access to what can be steered while the simulation runs.
     *
     * @return the control, for any thread
     */
    public SimulationControl control() {
        return simulation;
    }

    /**
     * Tells how far the simulation is.
     *
     * @return cycles of 20 ms so far
     */
    public long cycles() {
        return simulation.cycles();
    }

    /**
     * Tells whether the world keeps step with the clock.
     *
     * @return cycles that real time had and the world had not, so far
     */
    public long missedCycles() {
        return simulation.missedCycles();
    }

    /**
     * Tells how many programs play along.
     *
     * @return agents that are connected, with or without a robot
     */
    public int connectedAgents() {
        return simulation.connectedAgents();
    }

    /**
     * Tells what the simulation costs.
     *
     * @return seconds of processor time that its thread has used so far; NaN where the system does not tell
     */
    public double processorSeconds() {
        ThreadMXBean threads = ManagementFactory.getThreadMXBean();
        return threads.isThreadCpuTimeSupported() ? threads.getThreadCpuTime(thread.getId()) / 1e9 : Double.NaN;
    }

    /**
     * Tells the true results of a simulation that has ended.
     *
     * @return the report, or empty while the simulation runs
     */
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
