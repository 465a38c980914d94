package org.robonewbie.programs.process;

import java.io.IOException;
import java.nio.file.Path;
import java.util.Collections;
import java.util.LinkedHashSet;
import java.util.Optional;
import java.util.Set;
import java.util.UUID;
import java.util.concurrent.TimeUnit;
import java.util.stream.Stream;

/**
 * The process of an untrusted program and all of its descendants. On Linux, daemons are identified by a variable in
 * their environment or by their working directory.
 */
public final class ProcessTree implements AutoCloseable {

    private static final String MARK = "ROBONEWBIE_PROGRAM";
    private static final long SECONDS_TO_END = 3;

    /** Number of times to kill the tree, because a process may fork just before it is killed. */
    private static final int ROUNDS = 3;

    private final Process process;
    private final Optional<Path> workFolder;
    private final String mark;
    private final Set<ProcessHandle> seen = new LinkedHashSet<>();

    private ProcessTree(Process process, Optional<Path> workFolder, String mark) {
        this.process = process;
        this.workFolder = workFolder.map(place -> place.toAbsolutePath().normalize());
        this.mark = mark;
    }

    /**
     * Starts a process.
     *
     * @param builder command and environment
     * @param workFolder working directory if only this program uses it; empty if it is shared
     * @return the running process
     * @throws IOException if it cannot be started
     */
    public static ProcessTree start(ProcessBuilder builder, Optional<Path> workFolder) throws IOException {
        String mark = UUID.randomUUID().toString();
        builder.environment().put(MARK, mark);
        return new ProcessTree(builder.start(), workFolder, mark);
    }

    /** {@return the process that was started, the root of the tree} */
    public Process process() {
        return process;
    }

    /** {@return whether the system reports which process owns a connection; otherwise, {@link #holds} is unreliable} */
    public static boolean hasConnections() {
        return LinuxProcess.hasConnections();
    }

    /**
     * Checks whether one end of a connection belongs to the program.
     *
     * @param ownPort TCP port of this end
     * @param otherPort TCP port of the other end
     * @return whether one of the processes owns that end; false if this is not known
     */
    public synchronized boolean holds(int ownPort, int otherPort) {
        Optional<String> socket = LinuxProcess.socket(ownPort, otherPort);
        findChildren();
        if (socket.isPresent() && !isHeld(socket.get())) {
            findRunaways();
        }
        return socket.isPresent() && isHeld(socket.get());
    }

    private boolean isHeld(String socket) {
        return seen.stream().anyMatch(handle -> LinuxProcess.holds(handle.pid(), socket));
    }

    /** Looks for new processes and returns all processes found so far, whether or not they are still running. */
    synchronized Set<ProcessHandle> look(boolean alsoRunaways) {
        findChildren();
        if (alsoRunaways) {
            findRunaways();
        }
        return Collections.unmodifiableSet(new LinkedHashSet<>(seen));
    }

    private void findChildren() {
        Stream.concat(Stream.of(process.toHandle()), process.descendants()).forEach(seen::add);
    }

    private void findRunaways() {
        LinuxProcess.marked(mark, workFolder).stream()
                .flatMap(pid -> ProcessHandle.of(pid).stream())
                .forEach(seen::add);
    }

    /** Kills all processes. */
    @Override
    public synchronized void close() {
        findChildren();
        process.destroyForcibly();
        for (int round = 0; round < ROUNDS; round++) {
            findChildren();
            findRunaways();
            seen.forEach(ProcessHandle::destroyForcibly);
        }
        try {
            process.waitFor(SECONDS_TO_END, TimeUnit.SECONDS);
        } catch (InterruptedException stopped) {
            Thread.currentThread().interrupt();
        }
    }
}
