package org.robonewbie.learning.optimise;

import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.Callable;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;

/** Threads that carry out trials side by side; results come back in the order of the tasks. */
final class Workers implements AutoCloseable {

    private final ExecutorService service;

    Workers(int threads) {
        this.service = Executors.newFixedThreadPool(threads, task -> {
            Thread thread = new Thread(task, "trial");
            thread.setDaemon(true);
            return thread;
        });
    }

    /** Carries out all tasks. */
    <T> List<T> all(List<Callable<T>> tasks) {
        try {
            List<T> results = new ArrayList<>();
            for (Future<T> future : service.invokeAll(tasks)) {
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
