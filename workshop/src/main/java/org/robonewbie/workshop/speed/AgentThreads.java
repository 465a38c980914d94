package org.robonewbie.workshop.speed;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.util.List;
import org.robonewbie.simulator.physics.Crew;
import org.robonewbie.simulator.server.ThreadCrew;

/** Runs the agents on several threads between two cycles. Their replies do not depend on the number of threads. */
final class AgentThreads implements AutoCloseable {

    private final ThreadCrew crew;

    /**
     * Starts the threads.
     *
     * @param threads number of threads including the caller of {@link #act}; at least 1
     */
    AgentThreads(int threads) {
        crew = new ThreadCrew(threads);
    }

    /**
     * Runs one cycle of each agent. Uses only one thread until all messages have arrived, because an agent that is waiting for its message
     * advances the world.
     */
    void act(List<BenchmarkAgent> agents, CrowdScene scene, int cycle) throws IOException {
        Crew all = crew.helpers().isEmpty() || haveAllMessages(agents) ? crew : Crew.ALONE;
        try {
            all.divide(agents.size(), agent -> act(agents.get(agent), scene, cycle));
        } catch (UncheckedIOException failed) {
            throw failed.getCause();
        }
    }

    private static boolean haveAllMessages(List<BenchmarkAgent> agents) throws IOException {
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
