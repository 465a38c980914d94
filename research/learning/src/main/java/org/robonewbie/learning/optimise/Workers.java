package org.robonewbie.learning.optimise;

import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.Callable;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;

/** Threads of this program that carry out trials side by side. */
final class Workers implements Evaluator {

    private final Subject subject;
    private final ExecutorService service;

    Workers(Subject subject, int threads) {
        this.subject = subject;
        this.service = Executors.newFixedThreadPool(threads, task -> {
            Thread thread = new Thread(task, "trial");
            thread.setDaemon(true);
            return thread;
        });
    }

    @Override
    public List<Evaluation> all(List<double[]> candidates, List<Long> seeds) {
        List<Callable<Evaluation>> tasks = new ArrayList<>();
        for (double[] candidate : candidates) {
            seeds.forEach(seed -> tasks.add(() -> subject.evaluate(candidate, seed)));
        }
        try {
            List<Evaluation> results = new ArrayList<>();
            for (Future<Evaluation> future : service.invokeAll(tasks)) {
                results.add(future.get());
            }
            return results;
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
            throw new IllegalStateException("The optimisation was interrupted.", e);
        } catch (ExecutionException e) {
            throw new IllegalStateException("A trial failed: " + e.getCause(), e);
        }
    }

    @Override
    public void close() {
        service.shutdownNow();
    }
}
