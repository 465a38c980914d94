package org.robonewbie.exercises.marking;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.function.Consumer;
import org.robonewbie.exercises.Exercise;
import org.robonewbie.exercises.grading.ProcessGrader;
import org.robonewbie.nao.file.FolderLock;
import org.robonewbie.nao.file.SubmittedFolder;
import org.robonewbie.nao.file.TemporaryFolder;
import org.robonewbie.nao.file.UnreadableFileException;
import org.robonewbie.nao.text.PrintableText;
import org.robonewbie.programs.CalledWronglyException;
import org.robonewbie.programs.Fingerprint;
import org.robonewbie.programs.process.RobotProcess;
import org.robonewbie.programs.process.Sandbox;
import org.robonewbie.trial.batch.BatchProgress;
import org.robonewbie.trial.batch.BatchRunner;
import org.robonewbie.trial.batch.ThreadRunner;

/**
 * Grades the programs of all students in a course in parallel, writes a table of grades and checks for plagiarism.
 * Grades are stored: running the command again resumes an interrupted run and grades only programs that have changed.
 *
 * @param sources submissions, or folders of submissions: a subfolder for each student, files such as {@code
 *     anna_Kick.java}, or files and links sent by students who use the web edition
 * @param exercises the exercises to grade
 * @param seeds the number of trials for each program
 * @param results folder for tables and stored grades
 * @param version version of the grader; grades from a different version are not reused
 * @param sandbox the sandbox of the programs
 * @param progress receives a line for each grade
 */
public record ClassMarking(
        List<Path> sources,
        List<Exercise> exercises,
        int seeds,
        Path results,
        String version,
        Sandbox sandbox,
        Consumer<String> progress) {

    private static final String ERROR = ": error: ";

    /** Compiler messages for an exhausted stack or heap. */
    private static final List<String> NESTED_TOO_DEEPLY =
            List.of("robonewbie: The compiler cannot read ", "The system is out of resources");

    /** Stores unmodifiable copies of the lists. */
    public ClassMarking {
        sources = List.copyOf(sources);
        exercises = List.copyOf(exercises);
    }

    /**
     * Grades all programs and writes {@code grades.csv}, {@code findings.csv}, {@code copies.csv} and {@code grades.html}.
     *
     * @return the page with the table
     * @throws IOException if a file cannot be written
     * @throws CalledWronglyException if there is nothing to grade, or another process is using the results folder
     */
    public Path run() throws IOException {
        Path kept = results.resolve("kept");
        Files.createDirectories(kept);
        FolderLock lock = FolderLock.take(kept.resolve("lock"))
                .orElseThrow(() -> new CalledWronglyException("Another grading run is using the folder " + results
                        + ". Wait until it ends, or choose another folder with --results."));
        try (lock;
                TemporaryFolder copies = TemporaryFolder.create("class")) {
            ClassFolder all = ClassFolder.read(sources, exercises, copies.path(), results);
            return run(all, new KeptMarks(kept, JudgesKey.ofUser()));
        }
    }

    private Path run(ClassFolder all, KeptMarks kept) throws IOException {
        List<Submission> submissions =
                all.submissions().values().stream().flatMap(List::stream).toList();
        CopyCheck.Result copies =
                CopyCheck.of(submissions); // before any program runs, because it could change the copies
        Map<Submission, Mark> marks = new HashMap<>();
        Map<Submission, String> missing = new LinkedHashMap<>();
        for (Submission submission :
                submissions) { // before any program runs, because it could change the stored grades
            String fingerprint = fingerprint(submission, submission.folder());
            missing.put(submission, fingerprint);
            kept.find(submission, fingerprint).ifPresent(mark -> marks.put(submission, mark));
        }
        missing.keySet().removeAll(marks.keySet());
        int reused = marks.size();
        markAll(missing, marks, kept);
        int changed = kept.repair();
        ClassTable table = new ClassTable(
                exercises,
                List.copyOf(all.submissions().keySet()),
                submissions.stream().map(marks::get).toList(),
                all.troubles(),
                copies,
                seeds);
        Path page = table.write(results);
        if (changed > 0) {
            progress.accept("These stored grades were changed while programs were running and have been restored: "
                    + changed + ".");
        }
        progress.accept(String.format(
                Locale.ROOT,
                "%d students, %d programs (%d already graded). %s",
                all.submissions().size(),
                submissions.size(),
                reused,
                table.sentence()));
        return page;
    }

    private void markAll(Map<Submission, String> missing, Map<Submission, Mark> marks, KeptMarks kept)
            throws IOException {
        int reused = marks.size();
        int count = reused + missing.size();
        int printed = 0;
        for (Mark mark : marks.values()) {
            printed++;
            progress.accept(line(mark, printed, count) + " (graded before)");
        }
        try (BatchRunner runner = new ThreadRunner();
                BatchProgress bar = BatchProgress.of("programs", count, reused)) {
            runner.run(
                    List.copyOf(missing.keySet()),
                    submission -> mark(submission, missing.getOrDefault(submission, ""), kept),
                    (submission, mark) -> {
                        marks.put(submission, mark);
                        bar.print(progress, line(mark, marks.size(), count));
                        bar.advance(mark.grade().isEmpty());
                    });
        }
    }

    /** Grades a program. A failure of the grader affects only this program. */
    private Mark mark(Submission submission, String fingerprint, KeptMarks kept) throws IOException {
        try (TemporaryFolder work = TemporaryFolder.create("program")) {
            Path copy = work.path().toRealPath();
            new SubmittedFolder(submission.folder(), place -> false).copyTo(copy);
            if (fingerprint(submission, copy).equals(fingerprint)) {
                Mark mark = grade(submission, copy);
                kept.keep(submission, fingerprint, mark);
                return mark;
            }
            return broken(submission, "Its files were changed during grading. Grade it again.");
        } catch (UnreadableFileException | RuntimeException | StackOverflowError | OutOfMemoryError failed) {
            return broken(submission, "It could not be graded: " + failed + ".");
        }
    }

    private Mark grade(Submission submission, Path copy) throws IOException {
        Path file =
                copy.resolve(submission.folder().relativize(submission.file()).toString());
        ProcessGrader.Result result = new ProcessGrader(seeds, 1, sandbox, Optional.empty(), line -> {})
                .grade(
                        submission.exercise(),
                        new RobotProcess.Request(file.toString(), List.of(copy), copy, true),
                        (seed, score) -> {});
        return result.grade().isPresent()
                ? new Mark(submission.student(), submission.exercise().name(), result.grade(), "")
                : broken(submission, reason(result.output(), String.valueOf(file.getFileName())));
    }

    /** Returns the compiler's first error without the file path, or the first line of output if there is no error. */
    private static String reason(List<String> output, String fileName) {
        if (output.stream().anyMatch(line -> NESTED_TOO_DEEPLY.stream().anyMatch(line::startsWith))) {
            return "It does not compile: expressions or blocks are nested too deeply for the compiler.";
        }
        return output.stream()
                .filter(line -> line.contains(ERROR))
                .map(line -> "It does not compile: "
                        + line.substring(Math.max(0, line.indexOf(fileName + ":")))
                                .replace(ERROR, ": "))
                .findFirst()
                .or(() -> output.stream()
                        .filter(line -> !line.isBlank())
                        .map(line -> line.replaceFirst("^robonewbie: ", ""))
                        .findFirst())
                .orElse("The program could not be started.");
    }

    private static Mark broken(Submission submission, String reason) {
        return new Mark(submission.student(), submission.exercise().name(), Optional.empty(), reason);
    }

    /** Returns the checksum of everything on which a grade depends: the student's files, the number of seeds and the version. */
    private String fingerprint(Submission submission, Path copy) throws IOException {
        return new Fingerprint()
                .add(seeds + " " + version + " " + submission.folder().relativize(submission.file()))
                .add(new SubmittedFolder(copy, place -> false))
                .text();
    }

    private static String line(Mark mark, int number, int count) {
        return String.format(
                Locale.ROOT,
                "%4d of %d  %-20s %-16s %4.1f points %s",
                number,
                count,
                PrintableText.of(mark.student()),
                mark.exercise(),
                mark.points(),
                mark.passed() ? "passed" : "  " + PrintableText.of(mark.finding()));
    }
}
