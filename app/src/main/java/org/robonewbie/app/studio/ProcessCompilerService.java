package org.robonewbie.app.studio;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import org.robonewbie.app.program.CalledWronglyException;
import org.robonewbie.app.program.ExampleSources;
import org.robonewbie.app.program.GuestProcess;
import org.robonewbie.app.program.StudentsProgram;
import org.robonewbie.app.program.WaitingProcess;
import org.robonewbie.nao.file.TextFile;
import org.robonewbie.studio.completion.Proposal;
import org.robonewbie.studio.program.CompilerService;
import org.robonewbie.studio.program.Remark;
import org.robonewbie.studio.program.RunningProgram;

/** The compiler and the processes behind the studio's room for programs. */
public final class ProcessCompilerService implements CompilerService, AutoCloseable {

    private final Path folder;
    private final WaitingProcess processes;
    private final ExampleSources sources = new ExampleSources();

    /**
     * Opens the workshop.
     *
     * @param folder where the programs are
     */
    public ProcessCompilerService(Path folder) {
        this.folder = folder;
        this.processes = new WaitingProcess(folder);
    }

    @Override
    public Path folder() {
        return folder;
    }

    @Override
    public List<String> examples() {
        return sources.names();
    }

    @Override
    public Optional<String> example(String name) {
        return sources.text(name);
    }

    @Override
    public String newProgram(Path file, Optional<String> text) {
        return sources.startingWith(file, text);
    }

    @Override
    public List<Remark> check(Path file, String text) {
        processes.prepare();
        return StudentsProgram.of(file, text, List.of(folder)).check().stream()
                .map(said -> new Remark(
                        (int) said.from(),
                        (int) said.to(),
                        (int) said.line(),
                        said.serious(),
                        said.text(),
                        said.hint()))
                .toList();
    }

    @Override
    public List<Proposal> complete(Path file, String text, int at) {
        return StudentsProgram.of(file, text, List.of(folder)).complete(at);
    }

    @Override
    public Optional<RunningProgram> start(Path file, int port, Runnable beforeStart) throws IOException {
        try {
            Optional<StudentsProgram.Compiled> compiled = StudentsProgram.of(
                            file, TextFile.read(file).content(), List.of(folder))
                    .compile();
            if (compiled.isEmpty()) {
                return Optional.empty();
            }
            beforeStart.run();
            List<String> options = List.of("--host", "127.0.0.1", "--port", Integer.toString(port), "--headless");
            Running program = new Running(processes.start(compiled.get(), options), compiled.get());
            processes.prepare();
            return Optional.of(program);
        } catch (CalledWronglyException refused) {
            throw new IllegalArgumentException(refused.getMessage(), refused);
        }
    }

    private record Running(GuestProcess process, StudentsProgram.Compiled compiled) implements RunningProgram {

        @Override
        public String output() {
            return process.output();
        }

        @Override
        public boolean isRunning() {
            return process.isRunning();
        }

        @Override
        public int exitCode() {
            return process.exitCode();
        }

        @Override
        public void close() {
            process.close();
            WaitingProcess.forget(compiled);
        }
    }

    @Override
    public void close() {
        processes.close();
    }
}
