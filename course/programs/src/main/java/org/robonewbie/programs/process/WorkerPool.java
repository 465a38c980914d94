package org.robonewbie.programs.process;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.Queue;
import java.util.Set;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.ConcurrentLinkedQueue;
import java.util.concurrent.LinkedBlockingQueue;
import org.robonewbie.programs.ClassPath;

/**
 * Pool of child processes that run one program repeatedly, each time with fresh static fields. The program's standard output
 * is discarded; its error output is printed. A program that terminates its process affects only its own run.
 */
public final class WorkerPool implements AutoCloseable {

    private static final int SECONDS_TO_END = 10;
    private static final int MAX_CHARACTERS = 300;

    /** Exit codes after SIGINT and SIGTERM. */
    private static final List<Integer> INTERRUPTED = List.of(130, 143);

    private final List<String> command;
    private final Set<Worker> workers = ConcurrentHashMap.newKeySet();
    private final Queue<Worker> idle = new ConcurrentLinkedQueue<>();

    /**
     * Creates an empty pool.
     *
     * @param program name of an example, a class or a Java file
     * @param classPath folders and jars with the user's classes
     */
    public WorkerPool(String program, List<Path> classPath) {
        command = JavaCommand.of(
                List.of(),
                ClassPath.ofThisProgram(),
                ProgramMain.class.getName(),
                List.of(ProgramMain.REPEAT, program, new ClassPath(classPath).text()));
    }

    /**
     * Runs the program once, in an idle process if there is one, otherwise in a new one.
     *
     * @param options arguments for its {@code main}
     * @return a sentence that explains why the program failed, or an empty string after success; an empty {@code Optional}
     *     if the user terminated the process
     * @throws IOException if no process can be started
     */
    public Optional<String> run(List<String> options) throws IOException {
        Worker worker = idle.poll();
        if (worker == null) {
            worker = new Worker();
            workers.add(worker);
        }
        Optional<String> failure = worker.run(options);
        if (worker.process.isRunning()) {
            idle.add(worker);
        }
        return failure;
    }

    @Override
    public void close() {
        workers.forEach(worker -> worker.process.close());
    }

    private final class Worker {

        private final BlockingQueue<String> answers = new LinkedBlockingQueue<>();
        private final ChildProcess process;
        private volatile String complaint = "";

        Worker() throws IOException {
            Path folder = Path.of("").toAbsolutePath();
            process = ChildProcess.start(
                    command, folder, false, ProgramOutput.of(this::print, answers::add), Limits.NONE);
        }

        /** Prints a line and remembers the first line of each run. */
        private void print(String line) {
            System.err.println(line);
            if (complaint.isEmpty()) {
                String text = line.strip();
                complaint = " It said: " + text.substring(0, Math.min(MAX_CHARACTERS, text.length()));
            }
        }

        Optional<String> run(List<String> options) throws IOException {
            complaint = "";
            process.call(String.join(WaitingProcess.SEPARATOR, options));
            String exitCode = nextAnswer();
            if (exitCode.isEmpty()) {
                process.awaitEnd(SECONDS_TO_END);
                return INTERRUPTED.contains(process.exitCode().orElse(1))
                        ? Optional.empty()
                        : Optional.of("The program ended its process." + complaint);
            }
            return Optional.of(exitCode.equals("0") ? "" : "The program failed." + complaint);
        }

        private String nextAnswer() throws IOException {
            try {
                return answers.take();
            } catch (InterruptedException stopped) {
                Thread.currentThread().interrupt();
                throw new IOException("The run was interrupted.", stopped);
            }
        }
    }
}
