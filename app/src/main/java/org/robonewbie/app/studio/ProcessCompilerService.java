package org.robonewbie.app.studio;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.robonewbie.nao.file.TemporaryFolder;
import org.robonewbie.nao.file.TextFile;
import org.robonewbie.programs.CalledWronglyException;
import org.robonewbie.programs.ExampleSources;
import org.robonewbie.programs.JavaSource;
import org.robonewbie.programs.Remark;
import org.robonewbie.programs.completion.Proposal;
import org.robonewbie.programs.process.WaitingProcess;
import org.robonewbie.studio.program.CompilerService;
import org.robonewbie.studio.program.FirstProgram;
import org.robonewbie.studio.program.RunningProgram;

/** Compiles programs in this process and runs each in its own process. */
public final class ProcessCompilerService implements CompilerService, AutoCloseable {

    private final Path folder;
    private final WaitingProcess processes;
    private final ExampleSources sources = new ExampleSources();
    private final List<String> options;
    private final Optional<FirstProgram> first;

    /**
     * Creates the service.
     *
     * @param folder folder of the programs
     */
    public ProcessCompilerService(Path folder) {
        this(folder, List.of(), Optional.empty());
    }

    /**
     * Creates the service for a studio opened by a program that is already running.
     *
     * @param folder folder of the programs
     * @param options options for the robots of all programs
     * @param first the program that is already running, if there is one
     */
    public ProcessCompilerService(Path folder, List<String> options, Optional<FirstProgram> first) {
        this.folder = folder;
        this.options = List.copyOf(options);
        this.first = first;
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
        return JavaSource.of(file, text).check(List.of(folder));
    }

    @Override
    public List<Proposal> complete(Path file, String text, int at) {
        return JavaSource.of(file, text).complete(List.of(folder), at);
    }

    @Override
    public Optional<RunningProgram> start(Path file, int port, Runnable beforeStart) throws IOException {
        JavaSource source = JavaSource.of(file, TextFile.read(file).content());
        TemporaryFolder classes = TemporaryFolder.create("robonewbie-program");
        try {
            if (!source.compile(List.of(folder), classes.path())) {
                classes.close();
                return Optional.empty();
            }
        } catch (CalledWronglyException refused) {
            classes.close();
            throw new IllegalArgumentException(refused.getMessage(), refused);
        }
        beforeStart.run();
        List<String> all = new ArrayList<>(options);
        all.addAll(List.of("--host", "127.0.0.1", "--port", Integer.toString(port), "--headless"));
        RunningProgram program =
                new ProgramInProcess(processes.start(source.className(), classes.path(), all), classes);
        processes.prepare();
        return Optional.of(program);
    }

    @Override
    public Optional<FirstProgram> first() {
        return first;
    }

    @Override
    public void close() {
        processes.close();
    }
}
