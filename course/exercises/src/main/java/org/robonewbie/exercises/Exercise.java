package org.robonewbie.exercises;

import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.util.Objects;
import java.util.function.Supplier;

/**
 * An exercise: what to do, the program to start from, and how a solution is judged.
 *
 * <pre>{@code
 * Exercise kick = Exercises.find("kick").orElseThrow();
 * Grade grade = new Grader().grade(kick, MyKick::new, 3);
 * }</pre>
 *
 * @param number its position in the course, from 1
 * @param name such as {@code arm-by-side}
 * @param className name of the class in the start code, such as {@code ArmBySide}
 * @param title heading of the worksheet
 * @param minutes how long it takes a student, about
 * @param goal what the robot has to do, as a sentence
 * @param seconds simulated time of a trial
 * @param task creates the task of one trial
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

    /** {@return the name with the number, as the worksheets are called, such as {@code 03-arm-by-side}} */
    public String fullName() {
        return String.format("%02d-%s", number, name);
    }

    /**
     * Reads the program from which students start: it compiles, runs, and does not yet solve the task.
     *
     * @return the text of a Java file with a class of the name {@link #className}
     */
    public String startCode() {
        String file = "start/" + className + ".java.txt";
        try (InputStream stream =
                Objects.requireNonNull(Exercise.class.getResourceAsStream(file), "There is no start code " + file)) {
            return new String(stream.readAllBytes(), StandardCharsets.UTF_8);
        } catch (IOException unreadable) {
            throw new UncheckedIOException("The start code " + file + " cannot be read.", unreadable);
        }
    }
}
