package org.robonewbie.app.course;

import java.util.List;
import org.robonewbie.competition.contest.ChallengeContest;
import org.robonewbie.exercises.Exercise;
import org.robonewbie.exercises.Score;
import org.robonewbie.exercises.Task;

/** Makes contests of exercises, judged as at home. */
public final class ExerciseContests {

    /** What stands before the name of an exercise on the command line. */
    public static final String PREFIX = "exercise:";

    private ExerciseContests() {}

    /**
     * Makes a contest of an exercise.
     *
     * @param exercise the exercise
     * @param seed of the first trial; the next ones follow it
     * @param rounds trials of each team
     * @return the contest
     */
    public static ChallengeContest of(Exercise exercise, long seed, int rounds) {
        String rule = exercise.goal() + " " + rounds + (rounds == 1 ? " trial" : " trials") + " of 0 to "
                + Score.MOST_POINTS + " points; the most points win, equal points share a place.";
        return new ChallengeContest(
                "exercise-" + exercise.name(),
                "Exercise " + exercise.number() + ": " + exercise.title(),
                rule,
                exercise.task(),
                exercise.seconds(),
                seed,
                rounds,
                List.of(
                        new ChallengeContest.Column(Task.POINTS, "Points", Score.MOST_POINTS),
                        new ChallengeContest.Column(Task.PASSED, "Passed", 1)));
    }
}
