package org.robonewbie.app.course;

import java.util.List;
import org.robonewbie.competition.contest.ChallengeContest;
import org.robonewbie.competition.contest.Conditions;
import org.robonewbie.competition.contest.Criterion;
import org.robonewbie.competition.contest.StartPlace;
import org.robonewbie.exercises.Exercise;
import org.robonewbie.exercises.Score;
import org.robonewbie.exercises.Task;

/** Makes contests of exercises, judged as at home. */
public final class ExerciseContests {

    /** What stands before the name of an exercise on the command line. */
    public static final String PREFIX = "exercise:";

    private ExerciseContests() {}

    /**
     * Makes a contest of an exercise. Programs are told a place as in any game, which is not where they start.
     *
     * @param exercise the exercise
     * @param rounds trials of each team, each with the next seed
     * @param conditions the seed of the first trial
     * @return the contest
     */
    public static ChallengeContest of(Exercise exercise, int rounds, Conditions conditions) {
        String rule = exercise.goal() + " " + rounds + (rounds == 1 ? " trial" : " trials") + " of 0 to "
                + Score.MOST_POINTS + " points; the most points win, equal points share a place.";
        return new ChallengeContest(
                "exercise-" + exercise.name(),
                "Exercise " + exercise.number() + ": " + exercise.title(),
                rule,
                exercise.task(),
                new StartPlace(1, -1, 0, 0),
                exercise.seconds(),
                rounds,
                List.of(
                        Criterion.points(Task.POINTS, "Points", rounds * Score.MOST_POINTS),
                        Criterion.points(Task.PASSED, "Passed", rounds).onlyShown()),
                conditions);
    }
}
