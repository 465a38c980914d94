package org.robonewbie.simulator.server;

import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.OptionalInt;
import org.robonewbie.simulator.SimulationControl;
import org.robonewbie.simulator.cycle.WorldSettings;
import org.robonewbie.simulator.monitor.MonitorSettings;

/**
 * The configuration of a simulator.
 *
 * <pre>{@code
 * SimulatorSettings settings =
 *         SimulatorSettings.of(WorldSettings.league()).withAgentPort(0).withAwaitedAgents(2);
 * }</pre>
 *
 * @param world pitch, rules, noise, seed, and whether cycles wait for agents
 * @param agents settings for agent connections
 * @param monitors settings for monitor connections
 * @param speed simulated seconds per real second, or {@link SimulationControl#AS_FAST_AS_POSSIBLE}
 * @param seconds simulated seconds after which the simulation ends; infinite to run until it is closed
 * @param output the files to write
 */
public record SimulatorSettings(
        WorldSettings world, Agents agents, Monitors monitors, double speed, double seconds, Output output) {

    /** The agent port of the league. */
    public static final int DEFAULT_AGENT_PORT = 3100;

    /** The monitor port of the league. */
    public static final int DEFAULT_MONITOR_PORT = 3200;

    /** Default of {@link Agents#silentSeconds}. */
    public static final double DEFAULT_SILENT_AGENT_SECONDS = 60;

    /** The address for connections from this computer only. */
    public static final String LOCALHOST = "127.0.0.1";

    /**
     * Settings for agent connections.
     *
     * @param bindAddress local address to listen on, such as 127.0.0.1 for this computer only or 0.0.0.0 for all
     *     interfaces
     * @param port TCP port for agents, 0 for any free port; ignored if there are team endpoints
     * @param endpoints an endpoint for each team; empty for a single port for all agents
     * @param awaited number of agents that must have sent a message before the first cycle
     * @param silentSeconds real seconds after which an agent in another process is disconnected if it blocks sync mode
     */
    public record Agents(
            String bindAddress, int port, List<TeamEndpoint> endpoints, int awaited, double silentSeconds) {

        /** Makes the list unmodifiable. */
        public Agents {
            endpoints = List.copyOf(endpoints);
        }
    }

    /**
     * Settings for monitor connections.
     *
     * @param port TCP port for monitors and trainers, 0 for any free port; empty for no port
     * @param stepSeconds simulated seconds between messages to monitors, at least 0.02
     * @param trainers whether monitors may change the world
     * @param log file for a log that RoboViz can replay
     */
    public record Monitors(OptionalInt port, double stepSeconds, boolean trainers, Optional<Path> log) {

        /** No monitor port and no log. */
        public static final Monitors NONE =
                new Monitors(OptionalInt.empty(), MonitorSettings.DEFAULT_STEP_SECONDS, true, Optional.empty());
    }

    /**
     * The files that a simulator writes.
     *
     * @param recording file for the recording
     * @param report file for the report
     */
    public record Output(Optional<Path> recording, Optional<Path> report) {}

    /**
     * Returns the default settings for a world: agent port 3100 on this computer, real time, no monitors.
     *
     * @param world the world to simulate
     * @return the settings
     */
    public static SimulatorSettings of(WorldSettings world) {
        Agents agents = new Agents(LOCALHOST, DEFAULT_AGENT_PORT, List.of(), 0, DEFAULT_SILENT_AGENT_SECONDS);
        Output none = new Output(Optional.empty(), Optional.empty());
        return new SimulatorSettings(world, agents, Monitors.NONE, 1, Double.POSITIVE_INFINITY, none);
    }

    /**
     * Changes the settings for agent connections.
     *
     * @param value the new settings
     * @return a modified copy
     */
    public SimulatorSettings withAgents(Agents value) {
        return new SimulatorSettings(world, value, monitors, speed, seconds, output);
    }

    /**
     * Changes the port for agents.
     *
     * @param value TCP port, 0 for any free port
     * @return a modified copy
     */
    public SimulatorSettings withAgentPort(int value) {
        return withAgents(
                new Agents(agents.bindAddress, value, agents.endpoints, agents.awaited, agents.silentSeconds));
    }

    /**
     * Changes the number of awaited agents.
     *
     * @param value number of agents that must have sent a message before the first cycle
     * @return a modified copy
     */
    public SimulatorSettings withAwaitedAgents(int value) {
        return withAgents(new Agents(agents.bindAddress, agents.port, agents.endpoints, value, agents.silentSeconds));
    }

    /**
     * Changes the settings for monitor connections.
     *
     * @param value the new settings
     * @return a modified copy
     */
    public SimulatorSettings withMonitors(Monitors value) {
        return new SimulatorSettings(world, agents, value, speed, seconds, output);
    }

    /**
     * Opens a port for monitors.
     *
     * @param value TCP port, 0 for any free port
     * @return a modified copy
     */
    public SimulatorSettings withMonitorPort(int value) {
        return withMonitors(new Monitors(OptionalInt.of(value), monitors.stepSeconds, monitors.trainers, monitors.log));
    }

    /**
     * Changes the initial speed.
     *
     * @param value simulated seconds per real second, or {@link SimulationControl#AS_FAST_AS_POSSIBLE}
     * @return a modified copy
     */
    public SimulatorSettings withSpeed(double value) {
        return new SimulatorSettings(world, agents, monitors, value, seconds, output);
    }

    /**
     * Changes the duration.
     *
     * @param value simulated seconds; infinite to run until the simulator is closed
     * @return a modified copy
     */
    public SimulatorSettings withSeconds(double value) {
        return new SimulatorSettings(world, agents, monitors, speed, value, output);
    }

    /**
     * Changes the output files.
     *
     * @param recording file for the recording
     * @param report file for the report
     * @return a modified copy
     */
    public SimulatorSettings withOutput(Optional<Path> recording, Optional<Path> report) {
        return new SimulatorSettings(world, agents, monitors, speed, seconds, new Output(recording, report));
    }
}
