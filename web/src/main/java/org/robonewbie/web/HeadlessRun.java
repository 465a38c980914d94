package org.robonewbie.web;

import java.io.IOException;
import java.io.UncheckedIOException;
import org.robonewbie.agent.Agent;
import org.robonewbie.agent.AgentDriver;
import org.robonewbie.simulator.Console;
import org.robonewbie.simulator.cycle.SteppedSimulator;
import org.robonewbie.simulator.cycle.WorldSettings;
import org.robonewbie.simulator.recording.RunReport;

/**
 * A run that nobody watches, as fast as possible: what {@code robonewbie run --headless --fast} does, with the same results for the
 * same seed.
 */
final class HeadlessRun {

    private HeadlessRun() {}

    /**
     * Lets an agent play alone in the beginners' world.
     *
     * @param agent the agent
     * @param seed start of all random numbers
     * @param seconds simulated seconds
     * @return the true results
     */
    static RunReport of(Agent agent, long seed, double seconds) {
        WorldSettings settings = WorldSettings.beginner().withSeed(seed);
        try (SteppedSimulator simulator = SteppedSimulator.start(settings, Console.silent())) {
            simulator.endAfter(seconds);
            AgentDriver driver = new AgentDriver(agent);
            driver.play(simulator.connect(), driver.usualOptions());
            return simulator.report();
        } catch (IOException impossible) {
            throw new UncheckedIOException("The world of the page has closed its connection.", impossible);
        }
    }
}
