package org.robonewbie.exercises.progress;

import java.nio.file.Path;
import java.time.Instant;
import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;
import org.robonewbie.exercises.Exercise;
import org.robonewbie.exercises.Language;

/** Tracks a student's progress through the exercises, reveals hints one by one, and shows a solution after three tries. */
public final class ProgressService {

    private final ProgressStore store;
    private final SolutionRepository solutions;

    /**
     * Creates the service.
     *
     * @param store storage of the progress
     * @param solutions the solutions
     */
    public ProgressService(ProgressStore store, SolutionRepository solutions) {
        this.store = store;
        this.solutions = solutions;
    }

    /** {@return the service of the current user, with the solutions of this installation} */
    public static ProgressService ofUser() {
        Optional<Path> home =
                Optional.ofNullable(System.getProperty("robonewbie.home")).map(Path::of);
        return new ProgressService(new LocalProgress(ProgressFile.ofUser()), SolutionRepository.ofUser(home));
    }

    /**
     * The help that is available for an exercise.
     *
     * @param open the hints opened so far, in the order of the worksheet
     * @param all total number of hints
     * @param solution whether there is a solution that has not been locked by the teacher
     * @param triesLeft number of graded tries that are still required before the solution is shown
     */
    public record Hints(List<String> open, int all, boolean solution, int triesLeft) {}

    /** {@return the progress in all exercises} */
    public Progress progress() {
        return store.read();
    }

    /**
     * Records the start of work on an exercise.
     *
     * @param exercise the exercise
     */
    public void begun(Exercise exercise) {
        store.update(exercise, state -> state.seen(Instant.now()));
    }

    /**
     * Records a grade.
     *
     * @param exercise the exercise
     * @param points mean points of the trials, 0 to 10
     * @param passed whether all trials have passed
     * @param language language of the advice
     * @return advice on what to do next, as sentences; empty after a success
     */
    public List<String> graded(Exercise exercise, double points, boolean passed, Language language) {
        ExerciseProgress state = store.update(exercise, before -> before.tried(points, passed, Instant.now()));
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
     * @param language language of the hints
     * @return the hints opened so far
     */
    public Hints nextHint(Exercise exercise, Language language) {
        int all = Worksheet.of(exercise, language).hints().size();
        store.update(exercise, state -> state.withNextHint(all));
        return hints(exercise, language);
    }

    /**
     * Returns the hints opened so far.
     *
     * @param exercise the exercise
     * @param language language of the hints
     * @return the hints
     */
    public Hints hints(Exercise exercise, Language language) {
        List<String> all = Worksheet.of(exercise, language).hints();
        ExerciseProgress state = progress().of(exercise);
        int open = Math.min(state.hints(), all.size());
        return new Hints(all.subList(0, open), all.size(), solutions.offers(exercise), state.triesBeforeSolution());
    }

    /**
     * Requests a solution.
     *
     * @param exercise the exercise
     * @return the program, or the reason why it is not shown
     */
    public SolutionRepository.Answer solution(Exercise exercise) {
        SolutionRepository.Answer answer = solutions.ask(exercise, progress().of(exercise));
        if (answer.open()) {
            store.update(exercise, ExerciseProgress::withSolution);
        }
        return answer;
    }
}
