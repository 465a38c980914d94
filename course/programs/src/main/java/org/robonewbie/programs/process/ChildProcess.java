package org.robonewbie.programs.process;

import java.io.IOException;
import java.io.OutputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.time.Duration;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.Set;
import java.util.Timer;
import java.util.TimerTask;
import java.util.concurrent.TimeUnit;

/**
 * A running program and all of its descendant processes, which are killed together. Output is read as it arrives;
 * resource use is checked against the limits ten times per second.
 */
public final class ChildProcess implements AutoCloseable {

    private static final int MAX_PROCESSES = 200;
    private static final int LOOK_MILLISECONDS = 100;
    private static final int LOOKS_BETWEEN_RUNAWAYS = 20;

    private final ProcessTree processes;
    private final Process process;
    private final ProgramOutput output;
    private final Limits limits;
    private final Turns turns = new Turns();
    private final Timer timer = new Timer("limits-of-program", true);
    private final Map<ProcessHandle, Duration> processorTime = new HashMap<>();
    private long looks;
    private volatile Optional<Excess> excess = Optional.empty();

    private ChildProcess(ProcessTree processes, ProgramOutput output, Limits limits) {
        this.processes = processes;
        this.process = processes.process();
        this.output = output;
        this.limits = limits;
    }

    /** A limit that a program has exceeded. */
    public enum Excess {
        /** Too many processes at the same time. */
        PROCESSES,
        /** Too much memory. */
        MEMORY,
        /** Too much processor time. */
        PROCESSOR_TIME,
        /** No response for too long. */
        SILENCE
    }

    /**
     * Starts a program. If there are limits, environment variables that configure a JVM are removed.
     *
     * @param command program and arguments
     * @param folder the program's working directory
     * @param isAlone whether no other program uses this directory, in which case it identifies processes that have
     *     detached themselves from the tree
     * @param output captures the program's output
     * @param limits the program's resource limits
     * @return the running program
     * @throws IOException if it cannot be started
     */
    public static ChildProcess start(
            List<String> command, Path folder, boolean isAlone, ProgramOutput output, Limits limits)
            throws IOException {
        ProcessBuilder builder =
                new ProcessBuilder(command).directory(folder.toFile()).redirectErrorStream(true);
        if (!limits.equals(Limits.NONE)) {
            builder.environment()
                    .keySet()
                    .removeIf(name -> name.startsWith("ROBONEWBIE_")
                            || name.endsWith("JAVA_OPTIONS")
                            || name.equals("JAVA_TOOL_OPTIONS"));
        }
        ProcessTree processes = ProcessTree.start(builder, Optional.of(folder).filter(own -> isAlone));
        ChildProcess child = new ChildProcess(processes, output, limits);
        output.read(child.process.getInputStream());
        if (!limits.equals(Limits.NONE)) {
            child.timer.schedule(child.look(), 0, LOOK_MILLISECONDS);
        }
        return child;
    }

    private TimerTask look() {
        return new TimerTask() {
            @Override
            public void run() {
                check();
            }
        };
    }

    /**
     * Sends a call to the program, which receives it through {@link ParentProcess#nextCall}.
     *
     * @param line the call
     * @return whether it could be sent
     */
    public synchronized boolean call(String line) {
        OutputStream input = process.getOutputStream();
        try {
            input.write((line + "\n").getBytes(StandardCharsets.UTF_8));
            input.flush();
            return true;
        } catch (IOException ended) {
            return false;
        }
    }

    /** {@return the captured output} */
    public ProgramOutput output() {
        return output;
    }

    /** {@return whether the program is still running} */
    public boolean isRunning() {
        return process.isAlive();
    }

    /**
     * Passes the turn from the program to the simulated world or back; each of them computes during its own turn and
     * waits during the other's. The program has the first turn, in which it connects its robot.
     */
    public void passTurn() {
        turns.next();
    }

    /** {@return whether the program has connected its robot} */
    public boolean hasJoined() {
        return turns.hasBegun();
    }

    /**
     * {@return the time in seconds that the program has spent computing or sleeping in its current turn, while the
     * world waits; 0 during the world's turn}
     */
    public double waitedSeconds() {
        return turns.waitedSeconds();
    }

    /**
     * Checks whether one end of a connection belongs to the program.
     *
     * @param ownPort TCP port of this end
     * @param otherPort TCP port of the other end
     * @return whether a process of the program owns that end; false if this is not known
     */
    public boolean holds(int ownPort, int otherPort) {
        return processes.holds(ownPort, otherPort);
    }

    private synchronized void check() {
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
        if (alive > MAX_PROCESSES) { // checked first, because too many processes often exceed the memory limit too
            excess = Optional.of(Excess.PROCESSES);
        } else if (bytes > limits.residentBytes()) {
            excess = Optional.of(Excess.MEMORY);
        } else if (seconds > limits.processorSeconds()) {
            excess = Optional.of(Excess.PROCESSOR_TIME);
        } else if (hasJoined()
                && (waitedSeconds() > limits.silentSeconds() || turns.sleptSeconds() > limits.realSeconds())) {
            excess = Optional.of(Excess.SILENCE);
        }
        if (excess.isPresent()) {
            processes.close();
        }
    }

    /**
     * Waits until the program ends.
     *
     * @param seconds timeout in seconds
     * @return whether the program has ended
     */
    public boolean awaitEnd(double seconds) {
        try {
            return process.waitFor((long) (seconds * 1000), TimeUnit.MILLISECONDS);
        } catch (InterruptedException stopped) {
            Thread.currentThread().interrupt();
            return false;
        }
    }

    /** {@return the limit that the program exceeded; empty if it was not killed for this reason} */
    public Optional<Excess> excess() {
        if (excess.isEmpty() && !isRunning()) {
            output.await();
            return Optional.of(Excess.MEMORY).filter(full -> output.isOutOfMemory());
        }
        return excess;
    }

    /** {@return the exit code; empty while the program runs, or if it was killed for exceeding a limit} */
    public OptionalInt exitCode() {
        return excess.isPresent() || isRunning() ? OptionalInt.empty() : OptionalInt.of(process.exitValue());
    }

    /** Kills the program and its descendants. The output captured so far can still be read. */
    @Override
    public void close() {
        timer.cancel();
        processes.close();
        output.await();
    }
}
