package org.robonewbie.exercises.progress;

import java.util.Arrays;
import java.util.Collections;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import org.robonewbie.exercises.Exercise;
import org.robonewbie.exercises.Exercises;

/**
 * How far somebody is with all exercises.
 *
 * @param exercises the states by the exercises' names; those that nobody has begun are left out
 */
public record Progress(Map<String, ExerciseProgress> exercises) {

    /** Takes a copy. */
    public Progress {
        exercises = Collections.unmodifiableMap(new TreeMap<>(exercises));
    }

    /**
     * Returns the state of one exercise.
     *
     * @param exercise the exercise
     * @return its state
     */
    public ExerciseProgress of(Exercise exercise) {
        return exercises.getOrDefault(exercise.name(), ExerciseProgress.NONE);
    }

    /** {@return how many exercises are passed} */
    public long passed() {
        return Exercises.all().stream().filter(each -> of(each).passed()).count();
    }

    /** {@return the sum of the best points} */
    public double points() {
        return Exercises.all().stream()
                .mapToDouble(each -> of(each).bestPoints())
                .sum();
    }

    /** {@return the time of work on all exercises, in seconds} */
    public long seconds() {
        return Exercises.all().stream().mapToLong(each -> of(each).seconds()).sum();
    }

    /** {@return what was reached} */
    public List<Badge> badges() {
        return Arrays.stream(Badge.values())
                .filter(badge -> badge.isEarnedBy(this))
                .toList();
    }

    /**
     * Puts the progress of two people of one team together: each exercise counts by the better of both.
     *
     * @param other the progress of another member
     * @return the progress of both as a team
     */
    public Progress joined(Progress other) {
        Map<String, ExerciseProgress> both = new TreeMap<>(exercises);
        other.exercises.forEach((name, state) -> both.merge(name, state, Progress::joined));
        return new Progress(both);
    }

    private static ExerciseProgress joined(ExerciseProgress one, ExerciseProgress other) {
        return new ExerciseProgress(
                one.tries() + other.tries(),
                Math.max(one.bestPoints(), other.bestPoints()),
                one.passed() || other.passed(),
                one.seconds() + other.seconds(),
                Math.max(one.hints(), other.hints()),
                one.solutionSeen() || other.solutionSeen(),
                one.lastSeen().compareTo(other.lastSeen()) > 0 ? one.lastSeen() : other.lastSeen());
    }
}
