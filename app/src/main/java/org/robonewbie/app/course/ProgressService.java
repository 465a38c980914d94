package org.robonewbie.app.course;

import java.io.IOException;
import java.nio.file.Path;
import java.time.Clock;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.UnaryOperator;
import java.util.stream.Stream;
import org.robonewbie.exercises.Exercise;
import org.robonewbie.exercises.Language;
import org.robonewbie.exercises.progress.ExerciseProgress;
import org.robonewbie.exercises.progress.Progress;
import org.robonewbie.exercises.progress.ProgressFile;
import org.robonewbie.exercises.progress.SolutionRepository;
import org.robonewbie.exercises.progress.Worksheet;

/**
 * Accompanies a student through the exercises: keeps the progress, opens hints one after the other, and shows a solution after three
 * tries. Without a file, or with one that cannot be written, the progress lasts as long as the program.
 */
public final class ProgressService {

    private final Optional<ProgressFile> file;
    private final SolutionRepository solutions;
    private final Clock clock;
    private final Map<String, ExerciseProgress> remembered = new HashMap<>();
    private boolean unwritable;
    private boolean damageSaid;

    /**
     * Prepares the coach.
     *
     * @param file where progress is kept, if at all
     * @param solutions the solutions
     * @param clock says when something happens
     */
    public ProgressService(Optional<ProgressFile> file, SolutionRepository solutions, Clock clock) {
        this.file = file;
        this.solutions = solutions;
        this.clock = clock;
    }

    /** {@return the coach of this user, with the solutions of this installation} */
    public static ProgressService ofUser() {
        Optional<Path> home =
                Optional.ofNullable(System.getProperty("robonewbie.home")).map(Path::of);
        return new ProgressService(ProgressFile.ofUser(), SolutionRepository.ofUser(home), Clock.systemUTC());
    }

    /**
     * The hints of an exercise.
     *
     * @param open those that are open, in their order
     * @param all how many there are
     */
    public record Hints(List<String> open, int all) {}

    /** {@return how far the user is} */
    public synchronized Progress progress() {
        try {
            if (file.isEmpty() || unwritable) {
                return new Progress(remembered);
            }
            sayIfDamaged(file.get());
            return file.get().read();
        } catch (IOException unreadable) {
            complain(unreadable);
            return new Progress(remembered);
        }
    }

    /**
     * Notes that somebody begins with an exercise.
     *
     * @param exercise the exercise
     */
    public void begun(Exercise exercise) {
        change(exercise, state -> state.seen(clock.instant()));
    }

    /**
     * Notes a grade.
     *
     * @param exercise the exercise
     * @param points what was earned, 0 to 10
     * @param passed whether all trials have passed
     * @param language the language of what is said
     * @return what the student can do next, as sentences; empty after a success
     */
    public List<String> graded(Exercise exercise, double points, boolean passed, Language language) {
        ExerciseProgress state = change(exercise, before -> before.tried(points, passed, clock.instant()));
        return passed ? List.of() : advice(exercise, state, language);
    }

    private List<String> advice(Exercise exercise, ExerciseProgress state, Language language) {
        int hints = Worksheet.of(exercise, language).hints().size();
        boolean solution = state.triesBeforeSolution() == 0 && solutions.offers(exercise);
        String name = exercise.name();
        return Stream.of(
                        state.hints() < hints
                                ? "Hint " + (state.hints() + 1) + " of " + hints + ": robonewbie grade " + name
                                        + " --hint"
                                : "",
                        solution ? "Show me a solution: robonewbie grade " + name + " --solution" : "")
                .filter(line -> !line.isEmpty())
                .map(language::translated)
                .toList();
    }

    /**
     * Opens the next hint.
     *
     * @param exercise the exercise
     * @param language the language of the hints
     * @return all hints that are open now
     */
    public Hints nextHint(Exercise exercise, Language language) {
        int all = Worksheet.of(exercise, language).hints().size();
        change(exercise, state -> state.withNextHint(all));
        return hints(exercise, language);
    }

    /**
     * Returns the hints that are open.
     *
     * @param exercise the exercise
     * @param language the language of the hints
     * @return the hints
     */
    public Hints hints(Exercise exercise, Language language) {
        List<String> all = Worksheet.of(exercise, language).hints();
        int open = Math.min(progress().of(exercise).hints(), all.size());
        return new Hints(all.subList(0, open), all.size());
    }

    /**
     * Asks for a solution.
     *
     * @param exercise the exercise
     * @return the program, or why it is not shown
     */
    public SolutionRepository.Answer solution(Exercise exercise) {
        SolutionRepository.Answer answer = solutions.ask(exercise, progress().of(exercise));
        if (answer.open()) {
            change(exercise, ExerciseProgress::withSolution);
        }
        return answer;
    }

    /**
     * Checks whether a solution would be shown after enough tries.
     *
     * @param exercise the exercise
     * @return whether there is one that no teacher has locked
     */
    public boolean offersSolution(Exercise exercise) {
        return solutions.offers(exercise);
    }

    /**
     * Returns how many graded tries are missing until a solution is shown.
     *
     * @param exercise the exercise
     * @return the number, 0 if it may be shown
     */
    public int triesBeforeSolution(Exercise exercise) {
        return progress().of(exercise).triesBeforeSolution();
    }

    private synchronized ExerciseProgress change(Exercise exercise, UnaryOperator<ExerciseProgress> change) {
        if (file.isPresent() && !unwritable) {
            try {
                sayIfDamaged(file.get());
                return file.get().update(exercise, change);
            } catch (IOException failed) {
                complain(failed);
            }
        }
        return remembered.merge(
                exercise.name(), change.apply(ExerciseProgress.NONE), (before, fresh) -> change.apply(before));
    }

    /** Says it once: the file is empty or new afterwards. */
    private void sayIfDamaged(ProgressFile kept) throws IOException {
        if (!damageSaid && kept.isDamaged()) {
            damageSaid = true;
            System.err.println(
                    "The file of your progress, " + kept.file() + ", is damaged and counts as empty. With your next try"
                            + " it is kept as " + kept.damagedFile() + ", and a new one begins.");
        }
    }

    private void complain(IOException problem) {
        unwritable = true;
        System.err.println(
                "Your progress cannot be kept in " + file.orElseThrow().file() + " (" + problem.getMessage()
                        + "). Another file: set the environment variable " + ProgressFile.SWITCH + ".");
    }
}
