package org.robonewbie.programs.process;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.OptionalInt;
import org.robonewbie.nao.file.TemporaryFolder;
import org.robonewbie.programs.ClassPath;
import org.robonewbie.programs.SourceFolder;

/**
 * Compiles programs in processes of their own, in a sandbox where there is one: there the compiler sees the files of the program and no
 * others, so it can show no line of them.
 *
 * @param sandbox where the compiler runs, if there is a sandbox
 */
public record CompilerProcess(Sandbox sandbox) {

    private static final long SECONDS = 120;
    private static final int MAX_LINES = 10_000;

    /**
     * What the compiler has said.
     *
     * @param isCorrect whether there are classes now
     * @param classes those that can be started
     * @param lines notes, or complaints
     */
    public record Answer(boolean isCorrect, List<String> classes, List<String> lines) {}

    /**
     * Compiles sources.
     *
     * @param sources the sources
     * @param classes folder for the classes, which is emptied before
     * @return what the compiler has said
     * @throws IOException if the folder cannot be written
     */
    public Answer compile(SourceFolder sources, Path classes) throws IOException {
        TemporaryFolder.delete(classes);
        Files.createDirectories(classes);
        List<String> startable = new ArrayList<>();
        List<String> lines = new ArrayList<>();
        ProgramOutput output = ProgramOutput.of(
                line -> {
                    if (lines.size() < MAX_LINES) {
                        lines.add(line);
                    }
                },
                startable::add);
        Optional<String> trouble;
        boolean isCorrect;
        try (ChildProcess process =
                ChildProcess.start(command(sources, classes), classes, true, output, Limits.UNTIMED)) {
            process.awaitEnd(SECONDS);
            trouble = trouble(process);
            isCorrect = trouble.isEmpty() && process.exitCode().orElse(1) == 0;
        }
        startable.removeIf(String::isEmpty); // the mark of the end
        return new Answer(isCorrect, startable, trouble.map(List::of).orElse(lines));
    }

    private static Optional<String> trouble(ChildProcess process) {
        if (process.excess().isPresent()) {
            return Optional.of("The compiler needed more than " + JavaCommand.MEGABYTES + " MB of memory.");
        }
        OptionalInt code = process.exitCode();
        return code.isPresent() && code.getAsInt() <= 1
                ? Optional.empty()
                : Optional.of("The compiler did not come to its end within " + SECONDS + " s.");
    }

    private List<String> command(SourceFolder sources, Path classes) {
        ClassPath classPath = ClassPath.ofThisProgram();
        List<String> options = new ArrayList<>(JavaCommand.withMemory(JavaCommand.MEGABYTES));
        options.add(JavaCommand.QUICK_START);
        List<String> words = JavaCommand.of(
                options,
                classPath,
                ProgramMain.class.getName(),
                List.of(
                        ProgramMain.COMPILE,
                        sources.folder().toString(),
                        String.valueOf(sources.deep()),
                        classes.toString()));
        if (!sandbox.isUp()) {
            return words;
        }
        List<Path> readable = new ArrayList<>(JavaCommand.readable(classPath));
        readable.add(sources.folder());
        return sandbox.enclose(
                words,
                new SandboxPolicy(readable, List.of(), Optional.empty(), Optional.empty(), Optional.of(classes)));
    }
}
