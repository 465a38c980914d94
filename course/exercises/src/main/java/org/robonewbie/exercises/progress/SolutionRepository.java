package org.robonewbie.exercises.progress;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;
import org.robonewbie.exercises.Exercise;
import org.robonewbie.exercises.Exercises;
import org.robonewbie.nao.file.TextFile;

/**
 * The reference solutions, if this computer has them, and the teacher's lock: the file {@code locked.txt} in their folder names
 * exercises, one a line, whose solution is not shown yet; {@code all}, or a word that is no exercise, locks all.
 *
 * @param folder where the solutions are; empty if there are none
 */
public record SolutionRepository(Optional<Path> folder) {

    /** Environment variable: {@code off} shows no solution, anything else is the folder with the solutions. */
    public static final String SWITCH = "ROBONEWBIE_SOLUTIONS";

    private static final String LOCKS = "locked.txt";

    /**
     * An answer to somebody who asks for a solution.
     *
     * @param open whether it is a solution
     * @param text the program; or why there is none, as a sentence
     */
    public record Answer(boolean open, String text) {}

    /**
     * Returns the solutions of this installation: those of the teachers' zip or of the sources.
     *
     * @param home folder of the program; empty if it is not known
     * @return the shelf
     */
    public static SolutionRepository ofUser(Optional<Path> home) {
        String choice = Optional.ofNullable(System.getenv(SWITCH)).orElse("");
        if (choice.equalsIgnoreCase("off")) {
            return new SolutionRepository(Optional.empty());
        }
        Stream<Path> usual = home.stream()
                .flatMap(folder -> Stream.of(
                        folder.resolve("solutions"),
                        folder.resolve("course/exercises/src/test/java/org/robonewbie/exercises/solution")));
        return new SolutionRepository((choice.isEmpty() ? usual : Stream.of(Path.of(choice)))
                .filter(Files::isDirectory)
                .findFirst());
    }

    /**
     * Asks for a solution.
     *
     * @param exercise the exercise
     * @param state how far the student is with it
     * @return the program, or why it is not shown
     */
    public Answer ask(Exercise exercise, ExerciseProgress state) {
        Optional<Path> file = folder.map(place -> place.resolve(exercise.className() + ".java"))
                .filter(Files::isRegularFile);
        if (file.isEmpty()) {
            return new Answer(
                    false, "This computer has no solution of " + exercise.name() + ". Ask your teacher for it.");
        }
        if (isLocked(exercise)) {
            return new Answer(false, "Your teacher has locked the solution of " + exercise.name() + " for now.");
        }
        int missing = state.triesBeforeSolution();
        if (missing > 0) {
            return new Answer(
                    false,
                    "A solution is shown after " + ExerciseProgress.TRIES_BEFORE_SOLUTION + " graded tries: "
                            + (missing == 1 ? "one more." : missing + " more."));
        }
        return read(file.get());
    }

    /**
     * Checks whether there is a solution that nobody has locked.
     *
     * @param exercise the exercise
     * @return whether it would be shown after enough tries
     */
    public boolean offers(Exercise exercise) {
        return folder.map(place -> place.resolve(exercise.className() + ".java"))
                        .filter(Files::isRegularFile)
                        .isPresent()
                && !isLocked(exercise);
    }

    private static Answer read(Path file) {
        try {
            String text = TextFile.read(file).content();
            return new Answer(true, text.replaceFirst("(?m)^package .*;\\R+", ""));
        } catch (IOException unreadable) {
            return new Answer(false, "The solution cannot be shown. " + unreadable.getMessage());
        }
    }

    private boolean isLocked(Exercise exercise) {
        return locks().contains(exercise);
    }

    /**
     * The locked exercises. A lock that cannot be read, or that names no exercise, locks all: what a teacher has locked stays so. A
     * comment is a line with more than one word, or with {@code #}.
     */
    private List<Exercise> locks() {
        Optional<Path> file = folder.map(place -> place.resolve(LOCKS)).filter(Files::exists);
        List<Exercise> locked = new ArrayList<>();
        try {
            List<String> lines =
                    file.isPresent() ? TextFile.readAndNote(file.get()).lines() : List.of();
            for (String line : lines) {
                String word = line.strip();
                if (word.isEmpty() || word.startsWith("#") || word.contains(" ")) {
                    continue;
                }
                Optional<Exercise> exercise = Exercises.find(word);
                if (exercise.isEmpty()) {
                    return Exercises.all();
                }
                locked.add(exercise.get());
            }
            return locked;
        } catch (IOException unreadable) {
            return Exercises.all();
        }
    }
}
