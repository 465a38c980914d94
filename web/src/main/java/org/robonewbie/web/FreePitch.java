package org.robonewbie.web;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.util.List;
import java.util.function.IntPredicate;
import org.robonewbie.agent.Agent;
import org.robonewbie.agent.AgentDriver;
import org.robonewbie.protocol.order.Order;
import org.robonewbie.simulator.AgentMessages;
import org.robonewbie.simulator.WorldSnapshot;
import org.robonewbie.simulator.cycle.SteppedSimulator;
import org.robonewbie.simulator.cycle.WorldSettings;
import org.robonewbie.simulator.recording.RecordingTarget;
import org.robonewbie.studio.PageFeed;
import org.robonewbie.web.bytecode.Program;

/** The beginners' world, in which everybody may do everything, with one program. */
final class FreePitch implements WatchedWorld {

    private final SteppedSimulator simulator;
    private final PageFeed feed;
    private Runnable player = () -> {};

    /**
     * Prepares a pitch without robots.
     *
     * @param seed start of all random numbers
     * @param feed gets what happens
     * @param recording where a recording goes
     */
    FreePitch(long seed, PageFeed feed, RecordingTarget recording) {
        this.feed = feed;
        simulator = SteppedSimulator.start(WorldSettings.beginner().withSeed(seed), recording, feed::told);
        simulator.reportEventsTo(feed::happened);
    }

    /**
     * Lets an agent enter.
     *
     * @param agent the agent
     * @return this pitch
     */
    FreePitch with(Agent agent) {
        AgentDriver driver = new AgentDriver(agent);
        driver.publishTo(feed);
        PatientLink link = new PatientLink(simulator.connect());
        try {
            driver.join(link, driver.usualOptions().withSeconds(StudentProgram.FOREVER_SECONDS));
        } catch (IOException impossible) {
            throw new UncheckedIOException("The world of the page has closed its connection.", impossible);
        }
        link.beBusy();
        return playedBy(driver::goOn);
    }

    /**
     * Lets a program of a student enter.
     *
     * @param program its classes
     * @param run gets how it goes
     * @return this pitch
     */
    FreePitch with(Program program, StudentRun run) {
        return playedBy(
                run.begin(new StudentProgram(program, run.output(), simulator::connect, simulator::cycle, feed)));
    }

    private FreePitch playedBy(Runnable wanted) {
        player = wanted;
        player.run();
        return this;
    }

    @Override
    public void cycle() {
        simulator.cycle();
        player.run();
    }

    @Override
    public boolean isOver() {
        return false;
    }

    @Override
    public long cycles() {
        return simulator.cycles();
    }

    @Override
    public WorldSnapshot snapshot(boolean paused, double speed) {
        return simulator.snapshot(paused, speed);
    }

    @Override
    public void order(Order order) {
        simulator.order(order);
    }

    @Override
    public List<AgentMessages> messages(IntPredicate robots) {
        return simulator.messages(robots);
    }
}
