package org.robonewbie.trial.batch;

import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.CompletionService;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.ExecutorCompletionService;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;

/** Runs jobs on threads of this process. The receiver is called on the caller's thread. */
public final class ThreadRunner implements BatchRunner {

    private final ExecutorService executor;

    /** Creates a runner with a thread for each processor. */
    public ThreadRunner() {
        this(Runtime.getRuntime().availableProcessors());
    }

    /**
     * Creates a runner.
     *
     * @param threads the number of jobs to run in parallel, at least 1
     */
    public ThreadRunner(int threads) {
        this.executor = Executors.newFixedThreadPool(threads, work -> {
            Thread thread = new Thread(work, "batch");
            thread.setDaemon(true);
            return thread;
        });
    }

    @Override
    public String label() {
        return "local";
    }

    @Override
    public <P, R> List<R> run(List<P> parameters, Job<P, R> job, Receiver<? super P, ? super R> results)
            throws IOException {
        CompletionService<Result<R>> completed = new ExecutorCompletionService<>(executor);
        List<Future<Result<R>>> futures = new ArrayList<>(parameters.size());
        try {
            for (int i = 0; i < parameters.size(); i++) {
                int index = i;
                futures.add(completed.submit(() -> new Result<>(index, job.run(parameters.get(index)))));
            }
            for (int i = 0; i < parameters.size(); i++) {
                Result<R> next = completed.take().get();
                results.accept(parameters.get(next.index), next.value);
            }
            List<R> all = new ArrayList<>(parameters.size());
            for (Future<Result<R>> future : futures) {
                all.add(future.get().value);
            }
            return all;
        } catch (ExecutionException failed) {
            throw unchecked(failed);
        } catch (InterruptedException interrupted) {
            Thread.currentThread().interrupt();
            throw new IllegalStateException("The run was interrupted.", interrupted);
        } finally {
            futures.forEach(future -> future.cancel(true));
        }
    }

    private record Result<R>(int index, R value) {}

    private static RuntimeException unchecked(ExecutionException failed) throws IOException {
        Throwable cause = failed.getCause();
        if (cause instanceof Error error) {
            throw error;
        }
        if (cause instanceof RuntimeException unchecked) {
            return unchecked;
        }
        if (cause instanceof IOException io) {
            throw io;
        }
        return new IllegalStateException(cause == null ? "" : cause.getMessage(), cause);
    }

    @Override
    public void close() {
        executor.shutdownNow();
    }
}
