package org.robonewbie.app.recording;

import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.Queue;
import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.ConcurrentLinkedQueue;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;
import java.util.concurrent.TimeUnit;
import java.util.stream.IntStream;
import org.robonewbie.learning.dataset.DataSet;
import org.robonewbie.learning.dataset.RunResult;

/**
 * Records the runs of a data set in several processes at the same time. Which process carries out a run does not change its tables, since
 * each run has its own seed, its own simulator and a program that is loaded again.
 */
public final class ParallelRecording {

    private static final long SECONDS_TO_END = 10;

    private final Set<RecordingProcess> processes = ConcurrentHashMap.newKeySet();
    private final RunOrder order;
    private final int runs;
    private final DataSet set;
    private final List<String> command;

    /**
     * Prepares a recording.
     *
     * @param order what is recorded
     * @param runs how many runs are wanted
     * @param set where the tables go
     * @param command program and arguments of a process of {@link RunsOnCall}
     */
    public ParallelRecording(RunOrder order, int runs, DataSet set, List<String> command) {
        this.order = order;
        this.runs = runs;
        this.set = set;
        this.command = List.copyOf(command);
    }

    /**
     * Records all runs that are missing. The table of runs says which programs have failed; the other runs go on.
     *
     * @param most how many processes at the same time, at least 1
     * @throws IOException if the tables cannot be written
     */
    public void run(int most) throws IOException {
        Queue<Integer> missing = new ConcurrentLinkedQueue<>(IntStream.rangeClosed(1, runs)
                .filter(run -> !set.has(run))
                .boxed()
                .toList());
        ExecutorService threads = Executors.newFixedThreadPool(most);
        try {
            List<Future<?>> all = new ArrayList<>();
            for (int i = Math.min(most, missing.size()); i > 0; i--) {
                all.add(threads.submit(() -> work(missing)));
            }
            for (Future<?> each : all) {
                each.get();
            }
        } catch (ExecutionException failure) {
            missing.clear();
            breakOff(threads);
            throw failure.getCause() instanceof IOException unwritable ? unwritable : new IOException(failure);
        } catch (InterruptedException stopped) {
            Thread.currentThread().interrupt();
            throw new IOException("The recording was interrupted.", stopped);
        } finally {
            threads.shutdownNow();
        }
    }

    /** Where one run cannot be written, the others are not either; what they have begun takes room. */
    private void breakOff(ExecutorService threads) throws IOException {
        processes.forEach(RecordingProcess::close);
        threads.shutdown();
        try {
            threads.awaitTermination(SECONDS_TO_END, TimeUnit.SECONDS);
        } catch (InterruptedException stopped) {
            Thread.currentThread().interrupt();
        }
        for (int run = 1; run <= runs; run++) {
            if (!set.has(run)) {
                set.discard(run);
            }
        }
    }

    private Optional<RunResult> work(Queue<Integer> missing) throws IOException, InterruptedException {
        Optional<RunResult> last = Optional.empty();
        Integer run = missing.poll();
        while (run != null) {
            try (RecordingProcess process = new RecordingProcess(command)) {
                processes.add(process);
                while (run != null && process.isReady()) {
                    last = process.record(run, order.seed(run));
                    if (last.isPresent()) {
                        take(last.get());
                    }
                    run = missing.poll();
                }
            }
        }
        return last;
    }

    private void take(RunResult result) throws IOException {
        set.add(result);
        String outcome = result.hasTables()
                ? String.format(Locale.ROOT, "%d rows", result.rows())
                : "failed and is left out. " + result.failure();
        System.out.printf(Locale.ROOT, "run %d/%d, seed %d: %s%n", result.run(), runs, result.seed(), outcome);
    }
}
