package org.robonewbie.learning.policy;

import java.util.ArrayList;
import java.util.List;
import java.util.Queue;
import java.util.concurrent.ConcurrentLinkedQueue;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;
import java.util.function.Consumer;
import java.util.function.Function;
import java.util.function.Supplier;
import java.util.stream.IntStream;

/**
 * Worlds in which lessons are given side by side; results come back in the order of the lessons.
 *
 * @param <R> a world
 */
final class LessonRooms<R> implements AutoCloseable {

    private final ExecutorService threads;
    private final Consumer<R> end;
    private final Queue<R> free = new ConcurrentLinkedQueue<>();

    /** Opens worlds; the end closes each of them. */
    LessonRooms(int count, Supplier<? extends R> open, Consumer<R> end) {
        this.end = end;
        threads = Executors.newFixedThreadPool(count, work -> {
            Thread thread = new Thread(work, "lesson");
            thread.setDaemon(true);
            return thread;
        });
        IntStream.range(0, count).forEach(i -> free.add(open.get()));
    }

    /** Gives lessons, each in a room that is free. */
    <T> List<T> give(List<? extends Function<R, T>> lessons) {
        List<Future<T>> results = lessons.stream()
                .map(lesson -> threads.submit(() -> give(lesson)))
                .toList();
        List<T> figures = new ArrayList<>();
        try {
            for (Future<T> result : results) {
                figures.add(result.get());
            }
            return figures;
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
            throw new IllegalStateException("The training was interrupted.", e);
        } catch (ExecutionException e) {
            throw new IllegalStateException("A lesson failed: " + e.getCause(), e);
        }
    }

    private <T> T give(Function<R, T> lesson) {
        R room = free.remove();
        try {
            return lesson.apply(room);
        } finally {
            free.add(room);
        }
    }

    @Override
    public void close() {
        threads.shutdownNow();
        free.forEach(end);
    }
}
