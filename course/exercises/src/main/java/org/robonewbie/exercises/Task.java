package org.robonewbie.exercises;

import java.util.Map;
import org.robonewbie.trial.Challenge;

/**
 * What an exercise asks for in one trial, and how it is judged. As a measure its value is the points, so that an exercise can be
 * a contest or an objective too.
 */
public interface Task extends Challenge {

    /** Name of the figure of {@link #figures} with the points of the trial. */
    String POINTS = "points";

    /** Name of the figure of {@link #figures} that is 1 if the exercise was solved, else 0. */
    String PASSED = "passed";

    /** {@return how the trial ended} */
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
