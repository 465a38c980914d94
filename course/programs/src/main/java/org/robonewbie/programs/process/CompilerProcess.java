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
 * Compiles in a child process. In a sandbox, the compiler can read only the program's files, so its messages cannot quote any
 * other files.
 *
 * @param sandbox the sandbox in which the compiler runs
 */
public record CompilerProcess(Sandbox sandbox) {

    private static final long SECONDS = 120;

    /**
     * Result of a compilation.
     *
     * @param isCorrect whether there are no errors
     * @param classes the classes with a main method
     * @param lines the diagnostics
     */
    public record Answer(boolean isCorrect, List<String> classes, List<String> lines) {}

    /**
     * Compiles sources.
     *
     * @param sources the sources
     * @param classes folder for the class files, which is emptied first
     * @return the result
     * @throws IOException if the folder cannot be written
     */
    public Answer compile(SourceFolder sources, Path classes) throws IOException {
        TemporaryFolder.delete(classes);
        Files.createDirectories(classes);
        List<String> startable = new ArrayList<>();
        ProgramOutput output = ProgramOutput.of(line -> {}, startable::add);
        Optional<String> trouble;
        boolean isCorrect;
        try (ChildProcess process =
                ChildProcess.start(command(sources, classes), classes, true, output, Limits.UNTIMED)) {
            process.awaitEnd(SECONDS);
            trouble = trouble(process);
            isCorrect = trouble.isEmpty() && process.exitCode().orElse(1) == 0;
        }
        startable.removeIf(String::isEmpty); // end of the output
        return new Answer(isCorrect, startable, trouble.map(List::of).orElse(output.lines()));
    }

    private static Optional<String> trouble(ChildProcess process) {
        if (process.excess().isPresent()) {
            return Optional.of("The compiler needed more than " + JavaCommand.MEGABYTES + " MB of memory.");
        }
        OptionalInt code = process.exitCode();
        return code.isPresent() && code.getAsInt() <= 1
                ? Optional.empty()
                : Optional.of("The compiler did not finish within " + SECONDS + " s.");
    }

    private List<String> command(SourceFolder sources, Path classes) {
        ClassPath classPath = ClassPath.ofThisProgram();
        List<String> words = JavaCommand.ofProgram(
                JavaCommand.MEGABYTES,
                List.of(JavaCommand.QUICK_START),
                classPath,
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
