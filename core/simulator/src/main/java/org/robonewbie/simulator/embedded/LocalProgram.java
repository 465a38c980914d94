package org.robonewbie.simulator.embedded;

import java.io.IOException;
import java.util.List;
import java.util.concurrent.CopyOnWriteArrayList;
import org.robonewbie.protocol.frame.AgentLink;
import org.robonewbie.simulator.Console;
import org.robonewbie.simulator.JoinableSimulator;

/** The agents in this process. */
final class LocalProgram implements HostProgram {

    private final JoinableSimulator simulator;
    private final String name;
    private final String robot;
    private final Console console;
    private final List<AgentLink> robots = new CopyOnWriteArrayList<>();
    private volatile boolean isEnded;

    LocalProgram(JoinableSimulator simulator, String name, String robot, Console console) {
        this.simulator = simulator;
        this.name = name;
        this.robot = robot;
        this.console = console;
    }

    AgentLink connect() throws IOException {
        AgentLink robot = simulator.connect();
        robots.add(robot);
        return robot;
    }

    @Override
    public String name() {
        return name;
    }

    @Override
    public String robot() {
        return robot;
    }

    @Override
    public boolean isRunning() {
        return !isEnded;
    }

    @Override
    public synchronized void end() {
        if (isEnded) {
            return;
        }
        try {
            Runtime.getRuntime().addShutdownHook(new Thread(simulator::close, "end-of-simulator"));
        } catch (IllegalStateException shuttingDown) {
            return; // the program ends with its process
        }
        isEnded = true;
        robots.forEach(AgentLink::close);
        console.say("The studio has taken over. Press Control-C to stop.");
    }

    /** If a view has ended this program, waits until the simulation ends. */
    void awaitReplacement() {
        try {
            if (isEnded) {
                simulator.awaitEnd();
            }
        } catch (InterruptedException stop) {
            Thread.currentThread().interrupt();
        }
    }
}
