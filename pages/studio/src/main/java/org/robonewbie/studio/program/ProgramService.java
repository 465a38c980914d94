package org.robonewbie.studio.program;

import java.io.IOException;
import java.nio.file.Path;
import java.util.Optional;
import org.robonewbie.studio.program.ProgramRun.State;

/**
 * Runs one program at a time. When the program is replaced by another one, the world can continue from its current state.
 */
final class ProgramService implements AutoCloseable {

    private final CompilerService compiler;
    private final Arena arena;
    private Optional<RunningProgram> running;
    private volatile ProgramRun last;
    private long starts;

    ProgramService(CompilerService compiler, Arena arena) {
        this.compiler = compiler;
        this.arena = arena;
        this.running = compiler.first().map(FirstProgram::running);
        this.last = compiler.first()
                .map(first -> new ProgramRun(0, State.RUNNING, first.path(), "", 0))
                .orElse(ProgramRun.NONE);
    }

    /**
     * Compiles a program and replaces the running one, which keeps running if there are compile errors.
     *
     * @param path its path as used by pages
     * @param file its file
     * @param fromTheStart whether to reset the world instead of keeping its state
     */
    synchronized ProgramRun run(String path, Path file, boolean fromTheStart) throws IOException {
        int port = arena.agentPort()
                .orElseThrow(() -> new IllegalArgumentException(
                        "Programs cannot join this world from here. Start the studio with: robonewbie studio"));
        starts++;
        ProgramRun before = state();
        last = new ProgramRun(starts, State.STARTING, path, "", 0);
        Change change = new Change(fromTheStart);
        try {
            Optional<RunningProgram> started = compiler.start(file, port, change::begin);
            if (started.isEmpty()) {
                last = before;
                return new ProgramRun(starts, State.REFUSED, path, "", 0);
            }
            running = started;
            last = new ProgramRun(starts, State.RUNNING, path, "", 0);
            change.end(started.get());
        } catch (IOException | RuntimeException failed) {
            last = before;
            throw failed;
        }
        return state();
    }

    /** Keeps or resets the world's state while one program replaces another. */
    private final class Change {

        private final boolean fromTheStart;
        private Optional<Arena.Moment> moment = Optional.empty();

        Change(boolean fromTheStart) {
            this.fromTheStart = fromTheStart;
        }

        void begin() {
            boolean replaces = running.filter(RunningProgram::isRunning).isPresent();
            if (replaces && !fromTheStart) {
                moment = Optional.of(arena.keep());
            }
            running.ifPresent(RunningProgram::close);
            running = Optional.empty();
            arena.clearTelemetry();
            if (fromTheStart) {
                arena.reset();
            }
            arena.resume();
        }

        void end(RunningProgram program) {
            moment.ifPresent(kept -> kept.restore(program::isRunning));
        }
    }

    synchronized ProgramRun stop() {
        last = state();
        running.filter(RunningProgram::isRunning).ifPresent(program -> {
            program.close();
            last = new ProgramRun(last.id(), State.STOPPED, last.program(), program.output(), 0);
        });
        running = Optional.empty();
        return last;
    }

    ProgramRun state() {
        ProgramRun now = last;
        return now.state() == State.RUNNING ? present(now) : now;
    }

    private synchronized ProgramRun present(ProgramRun now) {
        return running.map(program -> new ProgramRun(
                        now.id(),
                        program.isRunning() ? State.RUNNING : State.ENDED,
                        now.program(),
                        program.output(),
                        program.exitCode()))
                .orElse(now);
    }

    @Override
    public void close() {
        stop();
    }
}
