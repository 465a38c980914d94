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
 * A process of a program that is not trusted, with all that it has started. On Linux processes that have left their parents are found
 * by a mark in their environment, or by the folder in which they work.
 */
public final class ProcessTree implements AutoCloseable {

    private static final String MARK = "ROBONEWBIE_PROGRAM";
    private static final long SECONDS_TO_END = 3;

    /** A process that is killed may have started another one in the moment before. */
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
     * @param builder its command and surroundings
     * @param workFolder a folder in which only this program works; empty if others may work where it does
     * @return the running process
     * @throws IOException if it cannot be started
     */
    public static ProcessTree start(ProcessBuilder builder, Optional<Path> workFolder) throws IOException {
        String mark = UUID.randomUUID().toString();
        builder.environment().put(MARK, mark);
        return new ProcessTree(builder.start(), workFolder, mark);
    }

    /** {@return the first process} */
    public Process process() {
        return process;
    }

    /** {@return whether this system tells whose a connection is, so that {@link #holds} can be believed} */
    public static boolean hasConnections() {
        return LinuxProcess.hasConnections();
    }

    /**
     * Looks whether one end of a connection belongs to the program.
     *
     * @param ownPort TCP port of this end
     * @param otherPort TCP port of the other end
     * @return whether one of the processes holds it; false where the system does not tell
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

    /** All processes that have been seen, running or not. */
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

    /** Ends all processes. */
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
