package org.robonewbie.app.recording;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.OutputStream;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.TimeUnit;
import org.robonewbie.competition.team.ProcessTree;
import org.robonewbie.learning.dataset.RunResult;

/** A process of {@link RunsOnCall}, as the one sees it that wants the runs. */
final class RecordingProcess implements AutoCloseable {

    private static final int SECONDS_TO_END = 10;
    private static final List<Integer> ENDED_BY_PEOPLE = List.of(130, 143);

    private final ProcessTree processes;
    private final Process process;
    private final BufferedReader answers;
    private final OutputStream calls;
    private boolean over;

    private RecordingProcess(ProcessTree processes) {
        this.processes = processes;
        this.process = processes.process();
        this.answers = process.inputReader(StandardCharsets.UTF_8);
        this.calls = process.getOutputStream();
    }

    static RecordingProcess start(List<String> command) throws IOException {
        ProcessBuilder builder = new ProcessBuilder(command).redirectError(ProcessBuilder.Redirect.INHERIT);
        return new RecordingProcess(ProcessTree.start(builder, Optional.empty()));
    }

    /** Whether it can carry out another run. */
    boolean isReady() {
        return !over && process.isAlive();
    }

    /**
     * Has a run carried out, and waits for its end.
     *
     * @return what became of it; empty if somebody has ended the process
     * @throws IOException if the tables cannot be written
     */
    Optional<RunResult> record(int run, long seed) throws IOException {
        Optional<String> answer = ask(run);
        if (answer.isEmpty()) {
            over = true;
            int code = exitCode();
            return ENDED_BY_PEOPLE.contains(code)
                    ? Optional.empty()
                    : Optional.of(RunResult.failed(run, seed, "Its process ended with exit code " + code + "."));
        }
        String text = answer.get();
        if (text.startsWith(RunsOnCall.STOP)) {
            throw new IOException(text.substring(RunsOnCall.STOP.length()));
        }
        over = text.startsWith(RunsOnCall.LAST_RUN);
        return RunResult.read(text.substring((over ? RunsOnCall.LAST_RUN : RunsOnCall.RUN).length()));
    }

    private Optional<String> ask(int run) {
        try {
            calls.write((run + "\n").getBytes(StandardCharsets.UTF_8));
            calls.flush();
            return Optional.ofNullable(answers.readLine());
        } catch (IOException gone) {
            return Optional.empty();
        }
    }

    private int exitCode() {
        try {
            return process.waitFor(SECONDS_TO_END, TimeUnit.SECONDS) ? process.exitValue() : 1;
        } catch (InterruptedException stopped) {
            Thread.currentThread().interrupt();
            return 1;
        }
    }

    @Override
    public void close() {
        processes.close();
    }
}
