package org.robonewbie.competition.team;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.Set;
import java.util.concurrent.TimeUnit;
import org.robonewbie.competition.contest.Ending;

/** The running program of a team, with all processes that it has started. */
public final class TeamProcess implements AutoCloseable {

    private static final long PATIENCE_SECONDS = 3;
    private static final int MOST_PROCESSES = 200;
    private static final int LOOKS_BETWEEN_RUNAWAYS = 20;

    private static final int SECONDS_TO_END = 5;

    private final ProcessTree processes;
    private final Process process;
    private final LogPump log;
    private final Limits limits;
    private final Path workFolder;
    private final Turns turns = new Turns();
    private final Map<ProcessHandle, Duration> processorTime = new HashMap<>();
    private long looks;
    private volatile Optional<Ending> brokenLimit = Optional.empty();

    private TeamProcess(ProcessTree processes, LogPump log, Limits limits, Path workFolder) {
        this.processes = processes;
        this.process = processes.process();
        this.log = log;
        this.limits = limits;
        this.workFolder = workFolder;
    }

    /**
     * Starts a program in a separate process.
     *
     * @param program the program
     * @param start what it receives
     * @param limits its limits
     * @param enclosure what encloses it
     * @param workFolder working folder of the program; created now, deleted at the end
     * @param log file for its output
     * @return the running program
     * @throws IOException if the process cannot be started
     */
    public static TeamProcess start(
            TeamProgram program, Start start, Limits limits, Enclosure enclosure, Path workFolder, Path log)
            throws IOException {
        TeamFolder.delete(workFolder);
        Files.createDirectories(workFolder);
        Optional<Path> own = program.folder();
        if (own.isPresent() && enclosure.door().isEmpty()) {
            TeamFolder.of(own.get(), List.of()).copyTo(workFolder);
        }
        ProcessBuilder builder = new ProcessBuilder(enclosure.around(
                        new ProgramCommand(program, start, limits).words(enclosure.temporary(workFolder)), program))
                .directory(workFolder.toFile())
                .redirectErrorStream(true);
        clearEnvironment(builder.environment());
        ProcessTree processes = ProcessTree.start(builder, Optional.of(workFolder));
        LogPump pump = LogPump.start(processes.process().getInputStream(), log);
        return new TeamProcess(processes, pump, limits, workFolder);
    }

    /** Takes out what would tell a Java of a team, or the compiler for it, more than its command line does. */
    static void clearEnvironment(Map<String, String> environment) {
        environment
                .keySet()
                .removeIf(name -> name.startsWith("ROBONEWBIE_")
                        || name.endsWith("JAVA_OPTIONS")
                        || name.equals("JAVA_TOOL_OPTIONS"));
    }

    /** {@return whether the program is still running} */
    public boolean isRunning() {
        return process.isAlive();
    }

    /** Notes that it is the program's turn, or the world's again; the first turn is the program's, to ask for its robot. */
    public void passTurn() {
        turns.next();
    }

    /** {@return whether the program has been given its first turn back} */
    public boolean hasJoined() {
        return turns.hasBegun();
    }

    /** {@return how long the world has been waiting for the program: what it has calculated or slept meanwhile, in seconds} */
    public double waitedSeconds() {
        return turns.waitedSeconds();
    }

    /**
     * Looks whether one end of a connection belongs to the program.
     *
     * @param ownPort TCP port of this end
     * @param otherPort TCP port of the other end
     * @return whether a process of the program holds it; false where the system does not tell
     */
    public boolean holds(int ownPort, int otherPort) {
        return processes.holds(ownPort, otherPort);
    }

    /** Looks what the program uses, and ends it if that is too much. */
    public synchronized void check() {
        Set<ProcessHandle> seen = processes.look(looks++ % LOOKS_BETWEEN_RUNAWAYS == 0);
        long bytes = 0;
        int alive = 0;
        for (ProcessHandle handle : seen) {
            handle.info().totalCpuDuration().ifPresent(used -> processorTime.put(handle, used));
            alive += handle.isAlive() ? 1 : 0;
            bytes += handle.isAlive() ? LinuxProcess.residentBytes(handle.pid()) : 0;
        }
        double seconds =
                processorTime.values().stream().mapToDouble(Duration::toMillis).sum() / 1000;
        boolean atWork = seen.stream().anyMatch(handle -> LinuxProcess.isAtWork(handle.pid()));
        turns.look(System.nanoTime() / 1e9, seconds, atWork);
        if (alive > MOST_PROCESSES) { // first, since so many take too much memory, too, when a look comes late
            brokenLimit = Optional.of(Ending.TOO_MANY_PROCESSES);
        } else if (bytes > limits.residentBytes()) {
            brokenLimit = Optional.of(Ending.TOO_MUCH_MEMORY);
        } else if (seconds > limits.processorSeconds()) {
            brokenLimit = Optional.of(Ending.TOO_MUCH_TIME);
        } else if (isSilent()) {
            brokenLimit = Optional.of(Ending.SILENT);
        }
        if (brokenLimit.isPresent()) {
            processes.close();
        }
    }

    private boolean isSilent() {
        return hasJoined()
                && (turns.waitedSeconds() > limits.silentSeconds() || turns.sleptSeconds() > limits.realSeconds());
    }

    /**
     * Returns why the program has ended. Waits a moment for its end.
     *
     * @return the reason; empty if it is still running
     */
    public Optional<Ending> ending() {
        if (brokenLimit.isPresent()) {
            return brokenLimit;
        }
        try {
            if (!process.waitFor(PATIENCE_SECONDS, TimeUnit.SECONDS)) {
                return Optional.empty();
            }
        } catch (InterruptedException stopped) {
            Thread.currentThread().interrupt();
        }
        log.await();
        return Optional.of(log.tellsLackOfMemory() ? Ending.TOO_MUCH_MEMORY : Ending.STOPPED);
    }

    /**
     * Returns how the program has ended by itself. One that has just closed its connection is given a moment to end.
     *
     * @return the exit code; empty if the program goes on, or if a limit ended it
     */
    public OptionalInt exitCode() {
        return brokenLimit.isPresent() || !hasEnded() ? OptionalInt.empty() : OptionalInt.of(process.exitValue());
    }

    private boolean hasEnded() {
        try {
            return process.waitFor(SECONDS_TO_END, TimeUnit.SECONDS);
        } catch (InterruptedException stopped) {
            Thread.currentThread().interrupt();
            return false;
        }
    }

    /** Ends the program with all that it has started, and deletes what it has written. */
    @Override
    public void close() {
        processes.close();
        log.await();
        TeamFolder.delete(workFolder);
    }
}
