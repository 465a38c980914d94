package org.robonewbie.programs.process;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import org.robonewbie.programs.ClassPath;

/** Keeps one idle process that has already loaded the framework, so that a program can start without waiting for a new JVM. */
public final class WaitingProcess implements AutoCloseable {

    static final String SEPARATOR = "\t";

    private final Path folder;
    private Optional<ChildProcess> waiting = Optional.empty();

    /**
     * Creates an instance without a process.
     *
     * @param folder working directory of the process
     */
    public WaitingProcess(Path folder) {
        this.folder = folder;
    }

    /** Starts a process if none is waiting. */
    public synchronized void prepare() {
        if (waiting.filter(ChildProcess::isRunning).isEmpty()) {
            waiting = Optional.of(start());
        }
    }

    private ChildProcess start() {
        try {
            return ChildProcess.start(
                    JavaCommand.ofProgram(
                            JavaCommand.MEGABYTES,
                            List.of(JavaCommand.QUICK_START),
                            ClassPath.ofThisProgram(),
                            List.of(ProgramMain.CALL)),
                    folder,
                    false,
                    ProgramOutput.of(line -> {}, answer -> {}),
                    Limits.NONE);
        } catch (IOException unstartable) {
            throw new UncheckedIOException("The program cannot be started: " + unstartable.getMessage(), unstartable);
        }
    }

    /**
     * Starts a program without delay in the JVM that is already running.
     *
     * @param className name of the program's main class
     * @param classes folder that contains the program's compiled classes
     * @param options arguments for its {@code main}
     * @return the program's process
     */
    public synchronized ChildProcess start(String className, Path classes, List<String> options) {
        prepare();
        ChildProcess process = waiting.orElseThrow();
        waiting = Optional.empty();
        process.call(className
                + SEPARATOR
                + new ClassPath(List.of(classes, folder)).text()
                + SEPARATOR
                + String.join(SEPARATOR, options));
        return process;
    }

    @Override
    public synchronized void close() {
        waiting.ifPresent(ChildProcess::close);
        waiting = Optional.empty();
    }
}
