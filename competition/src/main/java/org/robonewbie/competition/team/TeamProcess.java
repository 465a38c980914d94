package org.robonewbie.competition.team;

import java.io.File;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.TimeUnit;
import java.util.stream.Stream;
import org.robonewbie.competition.contest.Ending;

/** The running program of a team, with all processes that it has started. */
public final class TeamProcess implements AutoCloseable {

    private static final long PATIENCE_SECONDS = 3;

    private final Process process;
    private final LogPump log;
    private final Limits limits;
    private final Path workFolder;
    private final Turns turns = new Turns();
    private final Set<ProcessHandle> seen = new LinkedHashSet<>();
    private final Map<ProcessHandle, Duration> processorTime = new HashMap<>();
    private volatile Optional<Ending> brokenLimit = Optional.empty();

    private TeamProcess(Process process, LogPump log, Limits limits, Path workFolder) {
        this.process = process;
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
     * @param workFolder working folder of the program; created now, deleted at the end
     * @param log file for its output
     * @return the running program
     * @throws IOException if the process cannot be started
     */
    public static TeamProcess start(TeamProgram program, Start start, Limits limits, Path workFolder, Path log)
            throws IOException {
        TeamFolder.delete(workFolder);
        Files.createDirectories(workFolder);
        Optional<Path> own = folderOf(program);
        if (own.isPresent()) {
            TeamFolder.copy(own.get(), workFolder);
        }
        ProcessBuilder builder = new ProcessBuilder(command(program, start, limits, workFolder))
                .directory(workFolder.toFile())
                .redirectErrorStream(true);
        builder.environment()
                .keySet()
                .removeIf(name -> name.startsWith("ROBONEWBIE_") || name.endsWith("JAVA_OPTIONS"));
        builder.environment().remove("JAVA_TOOL_OPTIONS");
        Process process = builder.start();
        return new TeamProcess(process, LogPump.start(process.getInputStream(), log), limits, workFolder);
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

    /** Looks what the program uses, and ends it if that is too much. */
    public synchronized void check() {
        Stream.concat(Stream.of(process.toHandle()), process.descendants()).forEach(seen::add);
        long bytes = 0;
        for (ProcessHandle handle : seen) {
            handle.info().totalCpuDuration().ifPresent(used -> processorTime.put(handle, used));
            bytes += handle.isAlive() ? LinuxProcess.residentBytes(handle.pid()) : 0;
        }
        double seconds =
                processorTime.values().stream().mapToDouble(Duration::toMillis).sum() / 1000;
        boolean atWork = seen.stream().anyMatch(handle -> LinuxProcess.isAtWork(handle.pid()));
        turns.look(System.nanoTime() / 1e9, seconds, atWork);
        if (bytes > limits.residentBytes()) {
            brokenLimit = Optional.of(Ending.TOO_MUCH_MEMORY);
        } else if (seconds > limits.processorSeconds()) {
            brokenLimit = Optional.of(Ending.TOO_MUCH_TIME);
        } else if (isSilent()) {
            brokenLimit = Optional.of(Ending.SILENT);
        }
        if (brokenLimit.isPresent()) {
            end();
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

    /** Ends the program with all that it has started, and deletes what it has written. */
    @Override
    public void close() {
        end();
        log.await();
        TeamFolder.delete(workFolder);
    }

    private synchronized void end() {
        process.descendants().forEach(seen::add);
        process.destroyForcibly();
        seen.forEach(ProcessHandle::destroyForcibly);
        try {
            process.waitFor(PATIENCE_SECONDS, TimeUnit.SECONDS);
        } catch (InterruptedException stopped) {
            Thread.currentThread().interrupt();
        }
    }

    private static Optional<Path> folderOf(TeamProgram program) {
        if (program instanceof TeamProgram.OfJava java) {
            return java.folder();
        }
        return program instanceof TeamProgram.OfCommand command ? command.folder() : Optional.empty();
    }

    private static List<String> command(TeamProgram program, Start start, Limits limits, Path workFolder) {
        List<String> words = new ArrayList<>();
        words.add(Path.of(System.getProperty("java.home"), "bin", "java").toString());
        words.addAll(List.of("-XX:+UseSerialGC", "-XX:TieredStopAtLevel=1", "-XX:+ExitOnOutOfMemoryError"));
        words.add("-Xmx" + limits.memoryMegabytes() + "m");
        words.add("-Djava.awt.headless=true");
        words.add("-Djava.io.tmpdir=" + workFolder.toAbsolutePath());
        Optional.ofNullable(System.getProperty("robonewbie.home"))
                .ifPresent(home -> words.add("-Drobonewbie.home=" + home));
        if (program instanceof TeamProgram.OfJava java) {
            words.addAll(List.of("-cp", classPath(java.classPath()), TeamGuard.class.getName(), TeamGuard.CLASS));
            words.add(java.mainClasses().getOrDefault(start.role(), ""));
            words.addAll(start.options(java.together()));
            words.add("--headless");
        } else if (program instanceof TeamProgram.OfCommand command) {
            words.addAll(List.of("-cp", classPath(List.of()), TeamGuard.class.getName(), TeamGuard.COMMAND));
            words.addAll(start.fill(command.words(), command.together()));
        }
        return words;
    }

    private static String classPath(List<Path> own) {
        Stream<String> ours = Stream.of(System.getProperty("java.class.path").split(File.pathSeparator, -1));
        return String.join(
                File.pathSeparator,
                Stream.concat(ours.map(Path::of), own.stream())
                        .map(place -> place.toAbsolutePath().toString())
                        .toList());
    }
}
