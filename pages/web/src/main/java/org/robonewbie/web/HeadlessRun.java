package org.robonewbie.web;

import java.io.IOException;
import java.io.PrintStream;
import java.io.UncheckedIOException;
import org.robonewbie.agent.Agent;
import org.robonewbie.agent.AgentDriver;
import org.robonewbie.nao.Cycle;
import org.robonewbie.pagejvm.Program;
import org.robonewbie.protocol.telemetry.TelemetrySink;
import org.robonewbie.simulator.Console;
import org.robonewbie.simulator.cycle.SteppedSimulator;
import org.robonewbie.simulator.cycle.WorldSettings;
import org.robonewbie.simulator.recording.RunReport;

/**
 * A run without a display, as fast as possible: the counterpart of {@code robonewbie run --headless --fast}, with the
 * same results for the same seed.
 */
final class HeadlessRun {

    private HeadlessRun() {}

    /**
     * Runs a student's program alone in the beginners' world.
     *
     * @param program the program's classes
     * @param output receives the program's output
     * @param seed random seed
     * @param seconds time limit in simulated seconds
     * @return the ground-truth results
     */
    static RunReport of(Program program, PrintStream output, long seed, double seconds) {
        WorldSettings settings = WorldSettings.beginner().withSeed(seed);
        long cycles = Math.round(seconds / Cycle.SECONDS);
        try (SteppedSimulator simulator = SteppedSimulator.start(settings, Console.silent())) {
            simulator.endAfter(seconds);
            StudentProgram played =
                    new StudentProgram(program, output, simulator::connect, simulator::cycle, TelemetrySink.NONE);
            boolean isOver = false;
            while (!isOver && simulator.cycles() < cycles) {
                isOver = played.resume();
                if (isOver) {
                    played.leave();
                }
                simulator.cycle();
            }
            return simulator.report();
        }
    }

    /**
     * Runs an agent alone in the beginners' world.
     *
     * @param agent the agent
     * @param seed random seed
     * @param seconds simulated seconds
     * @return the ground-truth results
     */
    static RunReport of(Agent agent, long seed, double seconds) {
        WorldSettings settings = WorldSettings.beginner().withSeed(seed);
        try (SteppedSimulator simulator = SteppedSimulator.start(settings, Console.silent())) {
            simulator.endAfter(seconds);
            AgentDriver driver = new AgentDriver(agent);
            driver.play(simulator.connect(), driver.defaultOptions());
            return simulator.report();
        } catch (IOException impossible) {
            throw new UncheckedIOException("The simulator on this page has closed the connection.", impossible);
        }
    }
}
