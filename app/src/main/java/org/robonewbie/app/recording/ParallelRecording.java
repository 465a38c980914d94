package org.robonewbie.app.recording;

import java.io.IOException;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.Queue;
import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.ConcurrentLinkedQueue;
import java.util.stream.IntStream;
import org.robonewbie.learning.dataset.DataSet;
import org.robonewbie.learning.dataset.RunResult;
import org.robonewbie.trial.batch.BatchProgress;
import org.robonewbie.trial.batch.BatchRunner;
import org.robonewbie.trial.batch.ThreadRunner;

/**
 * Records the runs of a data set in several processes at the same time. Which process carries out a run does not change its tables, since
 * each run has its own seed, its own simulator and a program that is loaded again.
 */
public final class ParallelRecording {

    private final Set<RecordingProcess> processes = ConcurrentHashMap.newKeySet();
    private final Queue<RecordingProcess> idle = new ConcurrentLinkedQueue<>();
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
        List<Integer> missing = IntStream.rangeClosed(1, runs)
                .filter(run -> !set.has(run))
                .boxed()
                .toList();
        boolean complete = false;
        try (BatchRunner runner = new ThreadRunner(most);
                BatchProgress progress = BatchProgress.of("runs", runs, runs - missing.size())) {
            runner.run(missing, this::record, (run, result) -> take(result, progress));
            complete = true;
        } finally {
            processes.forEach(RecordingProcess::close);
            if (!complete) {
                discardIncomplete();
            }
        }
    }

    /** When one run cannot be written, neither can the others; their parts take room on the disk. */
    private void discardIncomplete() throws IOException {
        for (int run = 1; run <= runs; run++) {
            if (!set.has(run)) {
                set.discard(run);
            }
        }
    }

    private Optional<RunResult> record(int run) throws IOException {
        RecordingProcess process = idle.poll();
        if (process == null) {
            process = new RecordingProcess(command);
            processes.add(process);
        }
        Optional<RunResult> result = process.record(run, order.seed(run));
        if (process.isReady()) {
            idle.add(process);
        } else {
            process.close();
        }
        return result;
    }

    private void take(Optional<RunResult> recorded, BatchProgress progress) throws IOException {
        if (recorded.isEmpty()) {
            return;
        }
        RunResult result = recorded.get();
        set.add(result);
        String outcome = result.hasTables()
                ? String.format(Locale.ROOT, "%d rows", result.rows())
                : "failed and is left out. " + result.failure();
        progress.print(
                System.out::println,
                String.format(Locale.ROOT, "run %d/%d, seed %d: %s", result.run(), runs, result.seed(), outcome));
        progress.advance(!result.failure().isEmpty());
    }
}
