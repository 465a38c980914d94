package org.robonewbie.protocol.embedded;

import java.util.Optional;
import java.util.OptionalDouble;
import java.util.OptionalLong;

/**
 * Configuration of an embedded simulator.
 *
 * @param robot name of the robot that the program plays with, such as {@code NAO}
 * @param agentPort TCP port for agents in other processes; 0 for any free port
 * @param seed random seed; empty to choose one at random
 * @param fast whether to run as fast as possible instead of in real time
 * @param seconds simulated seconds after which the simulation stops; empty to run until it is closed
 * @param headless whether to run without the studio
 * @param openBrowser whether to open the studio in the user's browser
 * @param truth whether camera readings include the true pose of the robot and the true position of the ball, for
 *     experiments
 * @param scene name of the scene on the pitch; empty for the bare pitch
 * @param report path of the JSON report with ground-truth results, written at the end
 * @param recording path of the file in which the match is recorded
 * @param awaitedAgents number of agents to wait for before the clock starts, at least 1
 * @param agent name of the requesting program, for the recording's metadata
 */
public record SimulatorRequest(
        String robot,
        int agentPort,
        OptionalLong seed,
        boolean fast,
        OptionalDouble seconds,
        boolean headless,
        boolean openBrowser,
        boolean truth,
        Optional<String> scene,
        Optional<String> report,
        Optional<String> recording,
        int awaitedAgents,
        String agent) {}
