package org.robonewbie.exercises.progress;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;
import org.robonewbie.exercises.Exercise;
import org.robonewbie.exercises.Exercises;
import org.robonewbie.nao.file.TextFile;

/**
 * Reference solutions, and the teacher's locks: the file {@code locked.txt} in the same folder lists, one per line, the
 * exercises whose solutions must not be shown yet. A line with {@code all}, or with a word that is not the name of an
 * exercise, locks all solutions.
 *
 * @param source reads the files of the solutions
 */
public record SolutionRepository(Source source) {

    /** Environment variable that specifies the folder with the solutions; with {@code off}, no solutions are shown. */
    public static final String SWITCH = "ROBONEWBIE_SOLUTIONS";

    /** A repository without solutions. */
    public static final SolutionRepository NONE = new SolutionRepository(name -> Optional.empty());

    private static final String LOCKS = "locked.txt";

    /** Reads the files of a repository. */
    @FunctionalInterface
    public interface Source {

        /**
         * Reads a file.
         *
         * @param name name of the file
         * @return its text; empty if there is no such file
         * @throws IOException if the file cannot be read
         */
        Optional<String> read(String name) throws IOException;
    }

    /**
     * Answer to a request for a solution.
     *
     * @param open whether the solution is shown
     * @param text the program, or the reason why it is not shown, as a sentence
     */
    public record Answer(boolean open, String text) {}

    /**
     * Returns the solutions of this installation, from the teachers' zip archive or from a source tree.
     *
     * @param home folder of the program; empty if unknown
     * @return the repository
     */
    public static SolutionRepository ofUser(Optional<Path> home) {
        String choice = Optional.ofNullable(System.getenv(SWITCH)).orElse("");
        if (choice.equalsIgnoreCase("off")) {
            return NONE;
        }
        Stream<Path> usual = home.stream()
                .flatMap(folder -> Stream.of(
                        folder.resolve("solutions"),
                        folder.resolve("course/exercises/src/test/java/org/robonewbie/exercises/solution")));
        return (choice.isEmpty() ? usual : Stream.of(Path.of(choice)))
                .filter(Files::isDirectory)
                .findFirst()
                .map(SolutionRepository::ofFolder)
                .orElse(NONE);
    }

    /**
     * Returns the solutions in a folder.
     *
     * @param folder the folder
     * @return the repository
     */
    public static SolutionRepository ofFolder(Path folder) {
        return new SolutionRepository(name -> {
            Path file = folder.resolve(name);
            return Files.exists(file) ? Optional.of(TextFile.readAndNote(file).content()) : Optional.empty();
        });
    }

    /**
     * Returns the solution if the student may see it.
     *
     * @param exercise the exercise
     * @param state the student's progress
     * @return the program, or the reason why it is not shown
     */
    public Answer ask(Exercise exercise, ExerciseProgress state) {
        int missing = state.triesBeforeSolution();
        try {
            Optional<String> text = program(exercise);
            if (text.isEmpty()) {
                return new Answer(
                        false,
                        "There is no solution for " + exercise.name() + " on this computer. Ask your teacher for one.");
            }
            if (isLocked(exercise)) {
                return new Answer(false, "Your teacher has locked the solution for " + exercise.name() + " for now.");
            }
            return missing == 0
                    ? new Answer(true, text.get().replaceFirst("(?m)^package .*;(\r?\n)+", ""))
                    : new Answer(
                            false,
                            "A solution is shown after " + ExerciseProgress.TRIES_BEFORE_SOLUTION + " graded attempts: "
                                    + (missing == 1 ? "one more." : missing + " more."));
        } catch (IOException unreadable) {
            return new Answer(false, "The solution cannot be shown. " + unreadable.getMessage());
        }
    }

    /**
     * Checks whether there is a solution that has not been locked by the teacher.
     *
     * @param exercise the exercise
     * @return whether the solution is shown after enough tries
     */
    public boolean offers(Exercise exercise) {
        try {
            return program(exercise).isPresent() && !isLocked(exercise);
        } catch (IOException unreadable) {
            return false;
        }
    }

    private Optional<String> program(Exercise exercise) throws IOException {
        return source.read(exercise.fileName());
    }

    /**
     * Returns whether a solution is locked. All solutions are locked if {@code locked.txt} cannot be read or contains
     * an unknown name. Lines that start with {@code #} or contain several words are comments.
     */
    private boolean isLocked(Exercise exercise) {
        try {
            List<Optional<Exercise>> locked = source.read(LOCKS).stream()
                    .flatMap(text -> Arrays.stream(text.split("[\r\n]+", -1)))
                    .map(String::strip)
                    .filter(word -> !word.isEmpty() && !word.startsWith("#") && !word.contains(" "))
                    .map(Exercises::find)
                    .toList();
            return locked.contains(Optional.of(exercise)) || locked.contains(Optional.<Exercise>empty());
        } catch (IOException unreadable) {
            return true;
        }
    }
}
