package org.robonewbie.app.recording;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.LinkedBlockingQueue;
import org.robonewbie.learning.dataset.RunResult;
import org.robonewbie.programs.process.ChildProcess;
import org.robonewbie.programs.process.Limits;
import org.robonewbie.programs.process.ProgramOutput;

/** A process of {@link RunsOnCall}, as seen by the one that wants the runs. */
final class RecordingProcess implements AutoCloseable {

    private static final int SECONDS_TO_END = 10;
    private static final int MAX_CHARACTERS = 300;
    private static final List<Integer> ENDED_BY_USER = List.of(130, 143);

    private final BlockingQueue<String> answers = new LinkedBlockingQueue<>();
    private final ChildProcess process;
    private volatile String complaint = "";
    private boolean over;

    /** Starts the process. */
    RecordingProcess(List<String> command) throws IOException {
        process = ChildProcess.start(
                command, Path.of("").toAbsolutePath(), false, ProgramOutput.of(this::hear, answers::add), Limits.NONE);
    }

    /** Shows what a program complains about, and keeps the first line of it. */
    private void hear(String line) {
        System.err.println(line);
        if (complaint.isEmpty()) {
            complaint = line.strip()
                    .substring(0, Math.min(MAX_CHARACTERS, line.strip().length()));
        }
    }

    /** Whether it can carry out another run. */
    boolean isReady() {
        return !over && process.isRunning();
    }

    /**
     * Has a run carried out, and waits for its end.
     *
     * @return what became of it; empty if the user has ended the process
     * @throws IOException if the tables cannot be written
     */
    Optional<RunResult> record(int run, long seed) throws IOException {
        complaint = "";
        process.call(Integer.toString(run));
        String text = nextAnswer();
        if (text.isEmpty()) {
            over = true;
            process.awaitEnd(SECONDS_TO_END);
            int code = process.exitCode().orElse(1);
            return ENDED_BY_USER.contains(code)
                    ? Optional.empty()
                    : Optional.of(RunResult.failed(run, seed, "Its process ended with exit code " + code + "."));
        }
        if (text.startsWith(RunsOnCall.STOP)) {
            throw new IOException(text.substring(RunsOnCall.STOP.length()));
        }
        over = text.startsWith(RunsOnCall.LAST_RUN);
        return RunResult.read(text.substring((over ? RunsOnCall.LAST_RUN : RunsOnCall.RUN).length()))
                .map(this::withComplaint);
    }

    private String nextAnswer() throws IOException {
        try {
            return answers.take();
        } catch (InterruptedException stopped) {
            Thread.currentThread().interrupt();
            throw new IOException("The recording was interrupted.", stopped);
        }
    }

    private RunResult withComplaint(RunResult result) {
        return result.failure().isEmpty() || complaint.isEmpty()
                ? result
                : result.withFailure(result.failure() + " It said: " + complaint);
    }

    @Override
    public void close() {
        process.close();
    }
}
