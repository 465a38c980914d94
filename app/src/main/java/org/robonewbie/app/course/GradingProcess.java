package org.robonewbie.app.course;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.TimeUnit;
import java.util.stream.LongStream;
import org.robonewbie.app.program.StudentJava;
import org.robonewbie.exercises.Exercise;
import org.robonewbie.exercises.Grade;
import org.robonewbie.exercises.Score;
import org.robonewbie.nao.file.AtomicFile;

/**
 * Grades in a separate process, so that a program that ends the process, takes all memory or never returns costs its author the
 * trial and others nothing.
 */
public final class GradingProcess {

    /** Marks the process as the one in which the student's program runs, and where its result goes. */
    public static final String INSIDE = "--result-of-process";

    /** What stands in the file of the result while the student's program runs. */
    public static final String STARTED = "started";

    private static final int OUT_OF_MEMORY = 3;
    private static final int SECONDS_AT_LEAST = 60;
    private static final int SECONDS_FOR_EACH_SEED = 20;

    private final Exercise exercise;
    private final String program;
    private final int seeds;
    private final String classPath;
    private final Optional<Path> recording;
    private int exitCode;

    /**
     * Prepares the grading of one program.
     *
     * @param exercise what it is to solve
     * @param program class or Java file
     * @param seeds how many trials
     * @param classPath folders and jars with the student's classes
     * @param recording where the first trial is recorded, if at all
     */
    public GradingProcess(Exercise exercise, String program, int seeds, String classPath, Optional<Path> recording) {
        this.exercise = exercise;
        this.program = program;
        this.seeds = seeds;
        this.classPath = classPath;
        this.recording = recording;
    }

    /**
     * Grades, and waits for the end.
     *
     * @return the grade; none if the program cannot even begin, and why not has been shown
     * @throws IOException if the process cannot be started or its result cannot be read
     */
    public Optional<Grade> run() throws IOException {
        Path result = Files.createTempFile("grade", ".json");
        try {
            Process process = new ProcessBuilder(command(result))
                    .inheritIO()
                    .redirectInput(ProcessBuilder.Redirect.PIPE)
                    .start();
            process.getOutputStream().close(); // a program that reads from the terminal does not wait for anybody
            boolean ended = waitFor(process);
            process.descendants().forEach(ProcessHandle::destroyForcibly);
            process.destroyForcibly();
            exitCode = ended ? process.exitValue() : 1;
            String text = Files.readString(result);
            if (text.isEmpty()) {
                return Optional.empty();
            }
            return Optional.of(text.equals(STARTED) ? unfinished(ended) : Grade.ofJson(text));
        } finally {
            Files.deleteIfExists(result);
        }
    }

    /** {@return how the process ended} */
    public int exitCode() {
        return exitCode;
    }

    /**
     * Writes a file in one step, so that half of it is never read.
     *
     * @param file the file, which is replaced
     * @param text what it holds then
     */
    public static void write(Path file, String text) {
        try {
            AtomicFile.write(file, text);
        } catch (IOException unwritable) {
            throw new UncheckedIOException("The file " + file + " cannot be written.", unwritable);
        }
    }

    private List<String> command(Path result) {
        List<String> arguments = new ArrayList<>(
                List.of(exercise.name(), program, "--seeds", Integer.toString(seeds), INSIDE, result.toString()));
        if (!classPath.isEmpty()) {
            arguments.addAll(List.of("--class-path", classPath));
        }
        recording.ifPresent(file -> arguments.addAll(List.of("--record", file.toString())));
        return StudentJava.grade(List.of(), arguments);
    }

    private boolean waitFor(Process process) {
        try {
            return process.waitFor(SECONDS_AT_LEAST + (long) SECONDS_FOR_EACH_SEED * seeds, TimeUnit.SECONDS);
        } catch (InterruptedException end) {
            Thread.currentThread().interrupt();
            return false;
        }
    }

    private Grade unfinished(boolean ended) {
        String finding;
        if (!ended) {
            finding = "The program took too long.";
        } else if (exitCode == OUT_OF_MEMORY) {
            finding = "The program took all memory (" + StudentJava.MEGABYTES + " MB).";
        } else {
            finding = "The program ended the whole process (exit code " + exitCode + "). Does it call System.exit?";
        }
        Score score = Score.failed(0, finding, "Mend this first; the rest was not tried.");
        return new Grade(
                exercise.fullName(),
                LongStream.rangeClosed(1, seeds)
                        .mapToObj(seed -> new Grade.SeededScore(seed, score))
                        .toList());
    }
}
