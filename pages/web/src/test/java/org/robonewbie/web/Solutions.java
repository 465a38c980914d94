package org.robonewbie.web;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.robonewbie.agent.Agent;
import org.robonewbie.exercises.Exercise;
import org.robonewbie.exercises.Grade;
import org.robonewbie.exercises.Grader;
import org.robonewbie.exercises.Score;
import org.robonewbie.pagejvm.MemoryLoader;

/** The reference solutions of the exercises, as if typed by a student. */
public final class Solutions {

    private static final Path FOLDER =
            Path.of("../../course/exercises/src/test/java/org/robonewbie/exercises/solution");

    private Solutions() {}

    /**
     * Reads a solution.
     *
     * @param exercise the exercise
     * @return its source, without a package declaration
     */
    public static String text(Exercise exercise) {
        try {
            return Files.readString(FOLDER.resolve(exercise.fileName())).replaceFirst("package [^;]*;\\s*", "");
        } catch (IOException unreadable) {
            throw new UncheckedIOException(unreadable);
        }
    }

    /**
     * Judges a program on the JVM.
     *
     * @param exercise the exercise
     * @param classes its class files by name
     * @param seeds random seeds
     * @return the scores in order
     */
    public static List<Score> judged(Exercise exercise, Map<String, byte[]> classes, List<Long> seeds) {
        return new Grader()
                .grade(exercise, () -> agent(exercise.className(), classes), seeds, Optional.empty()).trials().stream()
                        .map(Grade.SeededScore::score)
                        .toList();
    }

    private static Agent agent(String name, Map<String, byte[]> classes) {
        try {
            return new MemoryLoader(classes)
                    .loadClass(name)
                    .asSubclass(Agent.class)
                    .getConstructor()
                    .newInstance();
        } catch (ReflectiveOperationException none) {
            throw new IllegalStateException(none);
        }
    }
}
