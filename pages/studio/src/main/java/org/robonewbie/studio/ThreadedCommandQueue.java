package org.robonewbie.studio;

import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionException;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.RejectedExecutionException;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.locks.LockSupport;
import java.util.function.BooleanSupplier;
import java.util.function.Consumer;
import java.util.function.Supplier;

/** Command queue with its own thread. */
final class ThreadedCommandQueue implements CommandQueue {

    private static final long TIMEOUT_NANOS = TimeUnit.SECONDS.toNanos(10);
    private static final long POLL_NANOS = TimeUnit.MILLISECONDS.toNanos(20);

    /** Timeout for an answer in seconds; longer than the time for which a running simulation waits for its agents. */
    private static final long ANSWER_SECONDS = 5;

    private final ExecutorService thread = Executors.newSingleThreadExecutor(ThreadedCommandQueue::newThread);

    private static Thread newThread(Runnable work) {
        Thread made = new Thread(work, "studio-commands");
        made.setDaemon(true);
        return made;
    }

    @Override
    public void later(Runnable work) {
        try {
            thread.execute(work);
        } catch (RejectedExecutionException ended) {
            // The studio is closing.
        }
    }

    @Override
    public <T> T result(Supplier<T> work) {
        CompletableFuture<T> answer = new CompletableFuture<>();
        later(() -> {
            try {
                answer.complete(work.get());
            } catch (IllegalStateException | IllegalArgumentException refused) {
                answer.completeExceptionally(refused);
            }
        });
        try {
            return answer.join();
        } catch (CompletionException e) {
            throw e.getCause() instanceof IllegalStateException refused
                    ? refused
                    : new IllegalStateException(e.getCause());
        }
    }

    @Override
    public <T> T answer(T none, Consumer<Consumer<T>> request) {
        CompletableFuture<T> answer = new CompletableFuture<>();
        request.accept(answer::complete);
        return answer.completeOnTimeout(none, ANSWER_SECONDS, TimeUnit.SECONDS).join();
    }

    @Override
    public void await(BooleanSupplier condition) {
        long end = System.nanoTime() + TIMEOUT_NANOS;
        while (!condition.getAsBoolean() && System.nanoTime() < end) {
            LockSupport.parkNanos(POLL_NANOS);
        }
    }

    @Override
    public void close() {
        thread.shutdownNow();
    }
}
