package org.robonewbie.learning.series;

import java.io.UncheckedIOException;
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
        CollectedTrials all = new CollectedTrials();
        run(experiment, trials, master, progress, all);
        return all.of(trials);
    }

    @Override
    public void run(String experiment, List<PlannedTrial> trials, String master, IntConsumer progress, TrialSink sink) {
        ClassLoader loader = Thread.currentThread().getContextClassLoader();
        Experiment.of(experiment);
        AtomicInteger done = new AtomicInteger();
        ExecutorService executor = Executors.newFixedThreadPool(threads);
        try {
            List<Future<?>> running = new ArrayList<>(trials.size());
            for (PlannedTrial trial : trials) {
                running.add(executor.submit(() -> {
                    Thread.currentThread().setContextClassLoader(loader);
                    runOne(experiment, trial, sink);
                    progress.accept(done.incrementAndGet());
                }));
            }
            awaitAll(running);
        } finally {
            executor.shutdownNow();
        }
    }

    private static void runOne(String experiment, PlannedTrial trial, TrialSink sink) {
        double[] numbers;
        try {
            numbers = trial.run(Experiment.of(experiment));
        } catch (IllegalStateException failed) {
            sink.failed(trial, String.valueOf(failed.getMessage()));
            return;
        }
        sink.measured(trial, numbers);
    }

    private static void awaitAll(List<Future<?>> running) {
        try {
            for (Future<?> trial : running) {
                trial.get();
            }
        } catch (ExecutionException failed) {
            if (failed.getCause() instanceof UncheckedIOException full) {
                throw full;
            }
            throw new IllegalStateException(
                    failed.getCause() == null ? "" : failed.getCause().getMessage(), failed);
        } catch (InterruptedException interrupted) {
            Thread.currentThread().interrupt();
            throw new IllegalStateException("The experiment was interrupted.", interrupted);
        }
    }
}
