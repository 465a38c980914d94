package org.robonewbie.app.command;

import java.util.List;
import org.robonewbie.competition.contest.ChallengeContest;
import org.robonewbie.competition.contest.Conditions;
import org.robonewbie.competition.contest.Criterion;
import org.robonewbie.competition.contest.StartPlace;
import org.robonewbie.exercises.Exercise;
import org.robonewbie.exercises.Score;
import org.robonewbie.exercises.Task;

/** Contests whose task is an exercise. */
final class ExerciseContests {

    /** Prefix of the command-line argument that marks an exercise. */
    static final String PREFIX = "exercise:";

    private ExerciseContests() {}

    /**
     * Creates a contest. Programs receive a start position, as in a match, but the exercise ignores it.
     *
     * @param exercise the exercise
     * @param rounds the number of trials for each team, with consecutive seeds
     * @param conditions the seed of the first trial
     * @return the contest
     */
    static ChallengeContest of(Exercise exercise, int rounds, Conditions conditions) {
        String rule = exercise.goal() + " " + rounds + (rounds == 1 ? " trial" : " trials") + " of 0 to "
                + Score.MAX_POINTS + " points; the most points win, and teams with equal points share a place.";
        return new ChallengeContest(
                "exercise-" + exercise.name(),
                "Exercise " + exercise.number() + ": " + exercise.title(),
                rule,
                exercise.task(),
                new StartPlace(1, -1, 0, 0),
                exercise.seconds(),
                rounds,
                List.of(
                        Criterion.points(Task.POINTS, "Points", rounds * Score.MAX_POINTS),
                        Criterion.points(Task.PASSED, "Passed", rounds).onlyShown()),
                conditions);
    }
}
