package org.robonewbie.app.program;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;

/** Keeps one process ready, so that a program starts without waiting for Java. */
public final class WaitingProcess implements AutoCloseable {

    private final Path folder;
    private Optional<GuestProcess> waiting = Optional.empty();

    /**
     * Prepares processes.
     *
     * @param folder their working directory
     */
    public WaitingProcess(Path folder) {
        this.folder = folder;
    }

    /** Starts a process if none is waiting. */
    public synchronized void prepare() {
        if (waiting.filter(GuestProcess::isRunning).isEmpty()) {
            waiting = Optional.of(GuestProcess.start(StudentJava.waiting(), folder));
        }
    }

    /**
     * Starts a program at once.
     *
     * @param program the program
     * @param options arguments of its {@code main}
     * @return its process
     */
    public synchronized GuestProcess start(StudentsProgram.Compiled program, List<String> options) {
        prepare();
        GuestProcess process = waiting.orElseThrow();
        waiting = Optional.empty();
        process.tell(ProgramOnCall.call(program.className(), List.of(program.folder(), folder), options));
        return process;
    }

    /**
     * Deletes the compiled classes of a program.
     *
     * @param program the program, which runs no more
     */
    public static void forget(StudentsProgram.Compiled program) {
        try (Stream<Path> files = Files.walk(program.folder())) {
            for (Path file : files.sorted(Comparator.reverseOrder()).toList()) {
                Files.deleteIfExists(file);
            }
        } catch (IOException inUse) {
            // Some classes in the system's temporary folder do no harm.
        }
    }

    @Override
    public synchronized void close() {
        waiting.ifPresent(GuestProcess::close);
        waiting = Optional.empty();
    }
}
