package org.robonewbie.studio.program;

import java.io.IOException;
import java.nio.file.Path;
import java.util.Optional;
import org.robonewbie.studio.program.ProgramRun.State;

/** Runs one program at a time on the pitch, and lets another version of it take its place while the world stands still. */
final class ProgramService implements AutoCloseable {

    private final CompilerService compiler;
    private final Arena arena;
    private Optional<RunningProgram> running = Optional.empty();
    private volatile ProgramRun last = ProgramRun.NONE;
    private long starts;

    ProgramService(CompilerService compiler, Arena arena) {
        this.compiler = compiler;
        this.arena = arena;
    }

    /**
     * Compiles a program and lets it take the place of the one that runs; if it has mistakes, that one runs on.
     *
     * @param path its path as pages know it
     * @param file its file
     * @param fromTheStart whether the world begins again; else it goes on as it is
     */
    synchronized ProgramRun run(String path, Path file, boolean fromTheStart) throws IOException {
        int port = arena.agentPort()
                .orElseThrow(() -> new IllegalArgumentException(
                        "Programs cannot join this world from here. Start the studio by: robonewbie studio"));
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

    /** What happens to the world while one program leaves and another one comes. */
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
            if (fromTheStart) {
                arena.reset();
            }
            arena.resume();
        }

        void end(RunningProgram program) {
            moment.ifPresent(kept -> kept.goOn(program::isRunning));
        }
    }

    /** Ends the program that runs. */
    synchronized ProgramRun stop() {
        last = state();
        running.filter(RunningProgram::isRunning).ifPresent(program -> {
            program.close();
            last = new ProgramRun(last.id(), State.STOPPED, last.program(), program.output(), 0);
        });
        running = Optional.empty();
        return last;
    }

    /** The present state. */
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
