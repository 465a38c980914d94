package org.robonewbie.simulator.server;

import java.io.IOException;
import org.robonewbie.protocol.frame.AgentLink;

/** An agent that waves its arms until its simulator ends, and is built and moves differently with each number. */
final class ScriptedAgent implements Runnable {

    private final TestAgent agent;
    private final String team;
    private final int number;

    ScriptedAgent(AgentLink link, String team, int number) {
        this.agent = new TestAgent(link);
        this.team = team;
        this.number = number;
    }

    @Override
    public void run() {
        try {
            agent.join("rsg/agent/nao/nao_hetero.rsg " + number % 3, team, number);
            agent.exchange("(beam -" + number + " " + number + " 0)(syn)");
            for (int cycle = 0; ; cycle++) {
                double speed = Math.sin(cycle * 0.1 * number);
                agent.exchange("(lae1 " + speed + ")(rle3 " + speed + ")(rle4 " + -speed + ")(say n" + number + "x"
                        + cycle + ")(syn)");
            }
        } catch (IOException e) {
            // The simulator has ended.
        }
    }

    /** Starts the agent in a thread of its own. */
    Thread start() {
        Thread thread = new Thread(this, "agent " + number);
        thread.setDaemon(true);
        thread.start();
        return thread;
    }
}
