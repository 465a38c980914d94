package org.robonewbie.bench.speed;

import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;

/** Lets robots think on several threads between two cycles. What they say does not depend on how many there are. */
final class AgentThreads implements AutoCloseable {

    private final int threads;
    private final ExecutorService helpers;

    /**
     * Creates threads.
     *
     * @param threads how many, with the one that calls {@link #act}; at least 1
     */
    AgentThreads(int threads) {
        this.threads = threads;
        helpers = Executors.newFixedThreadPool(Math.max(1, threads - 1));
    }

    /** Lets each agent act once, and waits for all. An agent that has no message yet lets its world go on, so all act on one thread then. */
    void act(List<BenchmarkAgent> agents, CrowdScene scene, int cycle) throws IOException {
        int shares = threads > 1 && areAllTold(agents) ? threads : 1;
        List<Future<?>> others = new ArrayList<>();
        for (int share = 1; share < shares; share++) {
            int first = share;
            others.add(helpers.submit(() -> {
                act(agents, first, shares, scene, cycle);
                return first;
            }));
        }
        act(agents, 0, shares, scene, cycle);
        for (Future<?> other : others) {
            await(other);
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

    private static void act(List<BenchmarkAgent> agents, int first, int shares, CrowdScene scene, int cycle)
            throws IOException {
        for (int i = first; i < agents.size(); i += shares) {
            agents.get(i).act(scene, cycle);
        }
    }

    private static void await(Future<?> share) throws IOException {
        try {
            share.get();
        } catch (InterruptedException interrupted) {
            Thread.currentThread().interrupt();
            throw new IOException("The benchmark was interrupted.", interrupted);
        } catch (ExecutionException failed) {
            if (failed.getCause() instanceof IOException cause) {
                throw cause;
            }
            throw new IllegalStateException("An agent of the benchmark failed.", failed.getCause());
        }
    }

    @Override
    public void close() {
        helpers.shutdownNow();
    }
}
