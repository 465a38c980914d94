package org.robonewbie.exercises;

import java.util.Map;
import org.robonewbie.trial.Challenge;

/**
 * Challenge for one trial of an exercise; it also computes the score. As a measure, its value is the number of points,
 * so an exercise can also serve as a contest or an optimisation objective.
 */
public interface Task extends Challenge {

    /** Key of the points in {@link #figures}. */
    String POINTS = "points";

    /** Key in {@link #figures} whose value is 1 if the exercise was solved and 0 otherwise. */
    String PASSED = "passed";

    /** {@return the score of the trial} */
    Score score();

    @Override
    default double value() {
        return score().points();
    }

    @Override
    default String unit() {
        return POINTS;
    }

    @Override
    default Map<String, Double> figures() {
        Score score = score();
        return Map.of(POINTS, (double) score.points(), PASSED, score.passed() ? 1.0 : 0.0);
    }
}
