package org.robonewbie.app.marking;

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
import org.robonewbie.app.course.GradingConditions;
import org.robonewbie.app.course.GradingProcess;
import org.robonewbie.competition.team.Fingerprint;
import org.robonewbie.exercises.Exercise;
import org.robonewbie.exercises.Grade;
import org.robonewbie.nao.file.FolderLock;
import org.robonewbie.nao.file.SubmittedFolder;
import org.robonewbie.nao.file.TemporaryFolder;
import org.robonewbie.nao.file.UnreadableFileException;
import org.robonewbie.nao.text.PrintableText;
import org.robonewbie.programs.CalledWronglyException;
import org.robonewbie.programs.process.RobotProcess;
import org.robonewbie.programs.process.Sandbox;
import org.robonewbie.trial.batch.BatchProgress;
import org.robonewbie.trial.batch.BatchRunner;
import org.robonewbie.trial.batch.ThreadRunner;

/**
 * Grades all programs of a class, as many at once as there are processors, into one table, and says which programs are copies. What was
 * graded is kept: the same order goes on where it was stopped, and grades what has changed.
 */
public final class ClassMarking {

    private static final String NO_REASON = "The program could not be started.";

    private final Path folder;
    private final List<Exercise> exercises;
    private final int seeds;
    private final Path results;
    private final String version;
    private final Sandbox sandbox;
    private final Consumer<String> progress;
    private int done;
    private int reused;

    /**
     * Prepares a marking.
     *
     * @param folder a folder for each student, or files such as {@code anna_Kick.java}
     * @param exercises the exercises that count
     * @param seeds how many trials each program has
     * @param results folder for tables and kept marks
     * @param version this version of the judge; a mark of another one is not reused
     * @param sandbox where programs run, if there is a sandbox
     * @param progress receives a sentence for each mark
     */
    public ClassMarking(
            Path folder,
            List<Exercise> exercises,
            int seeds,
            Path results,
            String version,
            Sandbox sandbox,
            Consumer<String> progress) {
        this.folder = folder;
        this.exercises = List.copyOf(exercises);
        this.seeds = seeds;
        this.results = results;
        this.version = version;
        this.sandbox = sandbox;
        this.progress = progress;
    }

    /**
     * Grades, and writes {@code grades.csv}, {@code findings.csv}, {@code copies.csv} and {@code grades.html}.
     *
     * @return the page with the table
     * @throws IOException if a file cannot be written
     * @throws CalledWronglyException if there is nothing to be graded, or another grading uses the folder of results
     */
    public Path run() throws IOException {
        Path kept = results.resolve("kept");
        Files.createDirectories(kept);
        FolderLock lock = FolderLock.take(kept.resolve("lock"))
                .orElseThrow(() -> new CalledWronglyException("Another grading is using the folder " + results
                        + ". Wait for its end, or choose another folder with --results."));
        try (lock;
                TemporaryFolder copies = TemporaryFolder.create("class")) {
            ClassFolder all = ClassFolder.read(folder, exercises, copies.path(), results);
            return run(all, new KeptMarks(kept, JudgesKey.ofUser()));
        }
    }

    private Path run(ClassFolder all, KeptMarks kept) throws IOException {
        List<Submission> submissions =
                all.submissions().values().stream().flatMap(List::stream).toList();
        CopyCheck.Result copies = CopyCheck.of(submissions); // before a program runs that could change the copies
        List<Mark> marks = markAll(submissions, kept);
        int changed = kept.repair();
        ClassTable table = new ClassTable(
                exercises, List.copyOf(all.submissions().keySet()), marks, all.troubles(), copies, seeds);
        Path page = table.write(results);
        if (changed > 0) {
            progress.accept("Kept marks that were changed while programs ran, and are again as the judge gave them: "
                    + changed + ".");
        }
        progress.accept(String.format(
                Locale.ROOT,
                "%d students, %d programs, %d of them graded before. %s",
                all.submissions().size(),
                submissions.size(),
                reused,
                table.sentence()));
        return page;
    }

    /** What was kept is read before the first program runs, which could write something else. */
    private List<Mark> markAll(List<Submission> submissions, KeptMarks kept) throws IOException {
        Map<Submission, String> fingerprints = new LinkedHashMap<>();
        Map<Submission, Mark> marks = new HashMap<>();
        for (Submission submission : submissions) {
            String fingerprint = fingerprint(submission, submission.folder());
            fingerprints.put(submission, fingerprint);
            kept.find(submission, fingerprint).ifPresent(mark -> marks.put(submission, mark));
        }
        reused = marks.size();
        marks.values().forEach(mark -> progress.accept(line(mark, submissions.size()) + " (graded before)"));
        fingerprints.keySet().removeAll(marks.keySet());
        try (BatchRunner runner = new ThreadRunner();
                BatchProgress bar = BatchProgress.of("programs", submissions.size(), reused)) {
            runner.run(
                    List.copyOf(fingerprints.keySet()),
                    submission -> mark(submission, fingerprints.getOrDefault(submission, ""), kept),
                    (submission, mark) -> {
                        marks.put(submission, mark);
                        bar.print(progress, line(mark, submissions.size()));
                        bar.advance(mark.grade().isEmpty());
                    });
        }
        return submissions.stream().map(marks::get).toList();
    }

    /** Whatever a program does to its judge costs itself the mark and no other one. */
    private Mark mark(Submission submission, String fingerprint, KeptMarks kept) throws IOException {
        try (TemporaryFolder work = TemporaryFolder.create("program")) {
            Path copy = work.path().toRealPath();
            new SubmittedFolder(submission.folder(), place -> false).copyTo(copy);
            if (fingerprint(submission, copy).equals(fingerprint)) {
                Mark mark = grade(submission, copy);
                kept.keep(submission, fingerprint, mark);
                return mark;
            }
            return broken(submission, "Its files were changed while the class was graded. Grade it again.");
        } catch (UnreadableFileException | RuntimeException | StackOverflowError | OutOfMemoryError failed) {
            return broken(submission, "It could not be graded: " + failed + ".");
        }
    }

    private Mark grade(Submission submission, Path copy) throws IOException {
        FirstLines output = new FirstLines();
        GradingConditions conditions = new GradingConditions(seeds, 1, sandbox, Optional.empty(), output);
        Path file =
                copy.resolve(submission.folder().relativize(submission.file()).toString());
        RobotProcess.Request program = new RobotProcess.Request(file.toString(), List.of(copy), copy, true);
        Optional<Grade> grade = new GradingProcess(submission.exercise(), program, conditions).run();
        return grade.isPresent()
                ? new Mark(submission.student(), submission.exercise().name(), grade, "")
                : broken(submission, output.reason(file).orElse(NO_REASON));
    }

    private static Mark broken(Submission submission, String reason) {
        return new Mark(submission.student(), submission.exercise().name(), Optional.empty(), reason);
    }

    /** All that a mark depends on: the student's files, the number of seeds, this version. */
    private String fingerprint(Submission submission, Path copy) throws IOException {
        return new Fingerprint()
                .add(seeds + " " + version + " " + submission.folder().relativize(submission.file()))
                .add(new SubmittedFolder(copy, place -> false))
                .text();
    }

    private String line(Mark mark, int count) {
        done++;
        return String.format(
                Locale.ROOT,
                "%4d of %d  %-20s %-16s %4.1f points %s",
                done,
                count,
                PrintableText.of(mark.student()),
                mark.exercise(),
                mark.points(),
                mark.passed() ? "passed" : "  " + PrintableText.of(mark.finding()));
    }
}
