package org.robonewbie.app.marking;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;
import java.util.function.Consumer;
import org.robonewbie.app.course.GradingConditions;
import org.robonewbie.app.course.GradingProcess;
import org.robonewbie.exercises.Exercise;
import org.robonewbie.exercises.Grade;

/**
 * Grades all programs of a class, as many at once as there are processors, into one table, and says which programs are copies. What was
 * graded is kept: the same order goes on where it was stopped, and grades what has changed.
 */
public final class ClassMarking {

    private static final String NO_REASON = "The program could not be started.";

    private final ClassFolder all;
    private final List<Exercise> exercises;
    private final int seeds;
    private final KeptMarks kept;
    private final Path results;
    private final Consumer<String> progress;
    private int done;
    private int reused;

    /**
     * Reads what was handed in.
     *
     * @param folder a folder for each student, or files such as {@code anna_Kick.java}
     * @param exercises the exercises that count
     * @param seeds how many trials each program has
     * @param results folder for tables and kept marks
     * @param version this version of the judge; a mark of another one is not reused
     * @param progress hears a sentence for each mark
     * @throws IOException if a folder cannot be read or written
     */
    public ClassMarking(
            Path folder, List<Exercise> exercises, int seeds, Path results, String version, Consumer<String> progress)
            throws IOException {
        Path kept = results.resolve("kept");
        Files.createDirectories(kept);
        this.all = ClassFolder.read(folder, exercises, results.resolve("renamed"));
        this.exercises = List.copyOf(exercises);
        this.seeds = seeds;
        this.kept = new KeptMarks(kept, seeds, version);
        this.results = results;
        this.progress = progress;
    }

    /**
     * Grades, and writes {@code grades.csv}, {@code findings.csv}, {@code copies.csv} and {@code grades.html}.
     *
     * @return the page with the table
     * @throws IOException if a file cannot be written
     */
    public Path run() throws IOException {
        List<Submission> submissions =
                all.submissions().values().stream().flatMap(List::stream).toList();
        List<Mark> marks = markAll(submissions);
        ClassTable table = new ClassTable(
                exercises,
                List.copyOf(all.submissions().keySet()),
                marks,
                all.troubles(),
                CopyCheck.of(submissions),
                seeds);
        Path page = table.write(results);
        progress.accept(String.format(
                Locale.ROOT,
                "%d students, %d programs, %d of them graded before. %s",
                all.submissions().size(),
                submissions.size(),
                reused,
                table.sentence()));
        return page;
    }

    private List<Mark> markAll(List<Submission> submissions) throws IOException {
        ExecutorService threads =
                Executors.newFixedThreadPool(Runtime.getRuntime().availableProcessors());
        try {
            List<Future<Mark>> coming = new ArrayList<>();
            for (Submission submission : submissions) {
                coming.add(threads.submit(() -> mark(submission, submissions.size())));
            }
            List<Mark> marks = new ArrayList<>();
            for (Future<Mark> mark : coming) {
                marks.add(mark.get());
            }
            return marks;
        } catch (ExecutionException failed) {
            throw new IOException("A program could not be graded: " + failed.getCause(), failed);
        } catch (InterruptedException stopped) {
            Thread.currentThread().interrupt();
            throw new IOException("The grading was stopped. The same command goes on where it was.", stopped);
        } finally {
            threads.shutdownNow();
        }
    }

    private Mark mark(Submission submission, int count) throws IOException {
        Optional<Mark> before = kept.find(submission);
        if (before.isPresent()) {
            tell(before.get(), count, true);
            return before.get();
        }
        Mark mark = grade(submission);
        kept.keep(submission, mark);
        tell(mark, count, false);
        return mark;
    }

    private Mark grade(Submission submission) throws IOException {
        FirstLines output = new FirstLines();
        GradingConditions conditions =
                new GradingConditions(seeds, 1, "", submission.folder().toAbsolutePath(), Optional.empty(), output);
        Optional<Grade> grade = new GradingProcess(
                        submission.exercise(),
                        submission.file().toAbsolutePath().toString(),
                        conditions)
                .run();
        return new Mark(
                submission.student(),
                submission.exercise().name(),
                grade,
                grade.isPresent() ? "" : output.reason(submission.file()).orElse(NO_REASON));
    }

    private synchronized void tell(Mark mark, int count, boolean reuse) {
        done++;
        reused += reuse ? 1 : 0;
        progress.accept(String.format(
                Locale.ROOT,
                "%4d of %d  %-20s %-16s %4.1f points %s%s",
                done,
                count,
                mark.student(),
                mark.exercise(),
                mark.points(),
                mark.passed() ? "passed" : "  " + mark.finding(),
                reuse ? " (graded before)" : ""));
    }
}
