package org.robonewbie.exercises.progress;

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

/**
 * Progress of a student through the exercises: stores results, reveals hints one by one, and shows a solution after three tries. Without a
 * file, or if it cannot be written, the progress lasts as long as this process.
 */
public final class ProgressService {

    private final Optional<ProgressFile> file;
    private final SolutionRepository solutions;
    private final Clock clock;
    private final Map<String, ExerciseProgress> remembered = new HashMap<>();
    private boolean unwritable;
    private boolean damageReported;

    /**
     * Creates a service.
     *
     * @param file file of the progress; empty for none
     * @param solutions the solutions
     * @param clock clock of the time stamps
     */
    public ProgressService(Optional<ProgressFile> file, SolutionRepository solutions, Clock clock) {
        this.file = file;
        this.solutions = solutions;
        this.clock = clock;
    }

    /** {@return the service for the current user, with the solutions of this installation} */
    public static ProgressService ofUser() {
        Optional<Path> home =
                Optional.ofNullable(System.getProperty("robonewbie.home")).map(Path::of);
        return new ProgressService(ProgressFile.ofUser(), SolutionRepository.ofUser(home), Clock.systemUTC());
    }

    /**
     * Hints of an exercise.
     *
     * @param open the revealed hints, in their order
     * @param all the total number of hints
     */
    public record Hints(List<String> open, int all) {}

    /** {@return the current progress} */
    public synchronized Progress progress() {
        try {
            if (file.isEmpty() || unwritable) {
                return new Progress(remembered);
            }
            warnIfDamaged(file.get());
            return file.get().read();
        } catch (IOException unreadable) {
            reportUnwritable(unreadable);
            return new Progress(remembered);
        }
    }

    /**
     * Records that the user has started an exercise.
     *
     * @param exercise the exercise
     */
    public void begun(Exercise exercise) {
        change(exercise, state -> state.seen(clock.instant()));
    }

    /**
     * Records a grade.
     *
     * @param exercise the exercise
     * @param points the points, 0 to 10
     * @param passed whether all trials have passed
     * @param language the language of the advice
     * @return sentences with next steps; empty after a success
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
     * Reveals the next hint.
     *
     * @param exercise the exercise
     * @param language the language of the hints
     * @return all revealed hints
     */
    public Hints nextHint(Exercise exercise, Language language) {
        int all = Worksheet.of(exercise, language).hints().size();
        change(exercise, state -> state.withNextHint(all));
        return hints(exercise, language);
    }

    /**
     * Returns the revealed hints.
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
     * Requests a solution.
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
     * Returns whether a solution is shown after enough tries.
     *
     * @param exercise the exercise
     * @return whether there is one that is not locked by the teacher
     */
    public boolean offersSolution(Exercise exercise) {
        return solutions.offers(exercise);
    }

    /**
     * Returns the number of graded tries until a solution is shown.
     *
     * @param exercise the exercise
     * @return the number, 0 if it can be shown now
     */
    public int triesBeforeSolution(Exercise exercise) {
        return progress().of(exercise).triesBeforeSolution();
    }

    private synchronized ExerciseProgress change(Exercise exercise, UnaryOperator<ExerciseProgress> change) {
        if (file.isPresent() && !unwritable) {
            try {
                warnIfDamaged(file.get());
                return file.get().update(exercise, change);
            } catch (IOException failed) {
                reportUnwritable(failed);
            }
        }
        return remembered.merge(
                exercise.name(), change.apply(ExerciseProgress.NONE), (before, fresh) -> change.apply(before));
    }

    /** Warns once about a damaged file. */
    private void warnIfDamaged(ProgressFile kept) throws IOException {
        if (!damageReported && kept.isDamaged()) {
            damageReported = true;
            System.err.println("Your progress file " + kept.file()
                    + " is damaged and treated as empty. Your next try renames it to " + kept.damagedFile()
                    + " and creates a new one.");
        }
    }

    private void reportUnwritable(IOException problem) {
        unwritable = true;
        System.err.println(
                "Your progress cannot be saved in " + file.orElseThrow().file() + " (" + problem.getMessage()
                        + "). To use another file, set the environment variable " + ProgressFile.SWITCH + ".");
    }
}
