package org.robonewbie.workshop.speed;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.util.List;
import org.robonewbie.simulator.physics.Crew;
import org.robonewbie.simulator.server.ThreadCrew;

/** Lets robots think on several threads between two cycles. What they say does not depend on how many there are. */
final class AgentThreads implements AutoCloseable {

    private final ThreadCrew crew;

    /**
     * Creates threads.
     *
     * @param threads how many, with the one that calls {@link #act}; at least 1
     */
    AgentThreads(int threads) {
        crew = new ThreadCrew(threads);
    }

    /** Lets each agent act once. An agent that has no message yet lets its world go on, so all act on one thread then. */
    void act(List<BenchmarkAgent> agents, CrowdScene scene, int cycle) throws IOException {
        Crew all = crew.helpers().isEmpty() || areAllTold(agents) ? crew : Crew.ALONE;
        try {
            all.divide(agents.size(), agent -> act(agents.get(agent), scene, cycle));
        } catch (UncheckedIOException failed) {
            throw failed.getCause();
        }
    }

    private static boolean areAllTold(List<BenchmarkAgent> agents) throws IOException {
        for (BenchmarkAgent agent : agents) {
            if (!agent.isMessageWaiting()) {
                return false;
            }
        }
        return true;
    }

    private static void act(BenchmarkAgent agent, CrowdScene scene, int cycle) {
        try {
            agent.act(scene, cycle);
        } catch (IOException failed) {
            throw new UncheckedIOException(failed);
        }
    }

    @Override
    public void close() {
        crew.close();
    }
}
