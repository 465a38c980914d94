package org.robonewbie.protocol.embedded;

import java.util.Optional;
import java.util.OptionalDouble;
import java.util.OptionalLong;

/**
 * How to run an embedded simulator.
 *
 * @param agentPort TCP port for agents of other processes; 0 takes any free one
 * @param seed start of all random numbers; empty draws one
 * @param fast whether to run as fast as possible instead of in real time
 * @param seconds simulated seconds after which the simulation ends; empty runs until closed
 * @param headless whether to do without the studio
 * @param openBrowser whether to open the studio in the user's browser
 * @param truth whether cameras also tell the true places of their robot and the ball, for experiments
 * @param scene name of what stands on the pitch; empty for the bare pitch
 * @param report name of the file for the true results as JSON, written at the end
 * @param recording name of the file for the recording of the run
 * @param awaitedAgents how many agents must be connected before the clock starts, at least 1
 * @param agent name of the program that asks, for the recording's card
 */
public record SimulatorRequest(
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
