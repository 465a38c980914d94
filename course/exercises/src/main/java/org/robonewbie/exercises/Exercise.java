package org.robonewbie.exercises;

import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.util.Objects;
import java.util.function.Supplier;

/**
 * An exercise with its goal, starter code and grading.
 *
 * <pre>{@code
 * Exercise kick = Exercises.find("kick").orElseThrow();
 * Grade grade = new Grader().grade(kick, MyKick::new, 3);
 * }</pre>
 *
 * @param number number in the course, starting at 1
 * @param name name, such as {@code arm-by-side}
 * @param className name of the class in the starter code, such as {@code ArmBySide}
 * @param title heading of the worksheet
 * @param minutes approximate time that a student needs, in minutes
 * @param goal what the robot has to do, as a sentence
 * @param seconds length of a trial in simulated seconds
 * @param task supplies a new task for each trial
 */
public record Exercise(
        int number,
        String name,
        String className,
        String title,
        int minutes,
        String goal,
        double seconds,
        Supplier<? extends Task> task) {

    private static final int FIRST_STEPS = 30;
    private static final int BASICS = 60;
    private static final int ADVANCED = 90;

    /** {@return the difficulty: {@code first steps}, {@code basics}, {@code advanced} or {@code challenge}} */
    public String level() {
        if (minutes <= FIRST_STEPS) {
            return "first steps";
        }
        if (minutes <= BASICS) {
            return "basics";
        }
        return minutes <= ADVANCED ? "advanced" : "challenge";
    }

    /** {@return the number and name, as used in worksheet file names, such as {@code 03-arm-by-side}} */
    public String fullName() {
        return String.format("%02d-%s", number, name);
    }

    /** {@return the name of the Java file for a solution, such as {@code ArmBySide.java}} */
    public String fileName() {
        return className + ".java";
    }

    /**
     * Returns the starter code, which compiles and runs but does not solve the exercise.
     *
     * @return source of a Java file with the class {@link #className}
     */
    public String startCode() {
        return text("start/" + className + ".java.txt");
    }

    /** Reads a resource file in UTF-8. */
    static String text(String file) {
        try (InputStream stream =
                Objects.requireNonNull(Exercise.class.getResourceAsStream(file), "There is no file " + file)) {
            return new String(stream.readAllBytes(), StandardCharsets.UTF_8);
        } catch (IOException unreadable) {
            throw new UncheckedIOException("The file " + file + " cannot be read.", unreadable);
        }
    }
}
