package org.robonewbie.learning.series;

import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.function.IntConsumer;

/** Carries out trials in this process on some threads. */
public final class LocalEngine implements ExperimentEngine {

    private final int threads;

    /** Uses all cores. */
    public LocalEngine() {
        this(Runtime.getRuntime().availableProcessors());
    }

    /**
     * Uses some threads.
     *
     * @param threads how many, at least 1
     */
    public LocalEngine(int threads) {
        this.threads = threads;
    }

    @Override
    public String label() {
        return "local";
    }

    @Override
    public List<double[]> run(String experiment, List<PlannedTrial> trials, String master, IntConsumer progress) {
        ClassLoader loader = Thread.currentThread().getContextClassLoader();
        Experiment.of(experiment);
        AtomicInteger done = new AtomicInteger();
        ExecutorService executor = Executors.newFixedThreadPool(threads);
        try {
            List<Future<double[]>> results = new ArrayList<>(trials.size());
            for (PlannedTrial trial : trials) {
                results.add(executor.submit(() -> {
                    Thread.currentThread().setContextClassLoader(loader);
                    double[] measured = trial.run(Experiment.of(experiment));
                    progress.accept(done.incrementAndGet());
                    return measured;
                }));
            }
            return collected(results);
        } finally {
            executor.shutdownNow();
        }
    }

    private static List<double[]> collected(List<Future<double[]>> results) {
        List<double[]> all = new ArrayList<>(results.size());
        try {
            for (Future<double[]> result : results) {
                all.add(result.get());
            }
        } catch (ExecutionException failed) {
            throw new IllegalStateException(
                    failed.getCause() == null ? "" : failed.getCause().getMessage(), failed);
        } catch (InterruptedException interrupted) {
            Thread.currentThread().interrupt();
            throw new IllegalStateException("The experiment was interrupted.", interrupted);
        }
        return all;
    }
}
