package org.robonewbie.workshop.sparring;

import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;

/**
 * Elo ratings of teams: the ratings that explain the results best, with a draw as half a win. A team with a rating 400 points
 * above another one is expected to win ten times as often as it loses. The mean rating of all teams is 0.
 *
 * <p>A weak prior of zero with a standard deviation of 400 points keeps the ratings finite for teams that win all matches.
 *
 * <p>Source: R. A. Bradley and M. E. Terry, <em>Rank analysis of incomplete block designs</em>, 1952.
 */
final class EloRatings {

    private static final double POINTS = 400 / Math.log(10);
    private static final double PRIOR_PRECISION = (POINTS / 400) * (POINTS / 400);
    private static final int ROUNDS = 200;

    private EloRatings() {}

    /**
     * Rating of a team.
     *
     * @param points rating
     * @param error standard error of the rating, given the ratings of all others
     */
    record Rating(double points, double error) {}

    /** Returns the ratings of all teams in the given results. */
    static Map<SparringTeam, Rating> of(List<SparringMatch.Result> results) {
        SparringTeam[] teams = results.stream()
                .flatMap(
                        result -> List.of(result.match().first(), result.match().second()).stream())
                .distinct()
                .toArray(SparringTeam[]::new);
        double[] strength = new double[teams.length];
        double[] information = new double[teams.length];
        for (int round = 0; round < ROUNDS; round++) {
            for (int i = 0; i < teams.length; i++) {
                double slope = -PRIOR_PRECISION * strength[i];
                information[i] = PRIOR_PRECISION;
                for (SparringMatch.Result result : results) {
                    int one = Arrays.asList(teams).indexOf(result.match().first());
                    int other = Arrays.asList(teams).indexOf(result.match().second());
                    if (one != other && (one == i || other == i)) {
                        double sign = one == i ? 1 : -1;
                        double wins = 1 / (1 + Math.exp(sign * (strength[other] - strength[one])));
                        slope += 0.5 + 0.5 * sign * Math.signum(result.goals()) - wins;
                        information[i] += wins * (1 - wins);
                    }
                }
                strength[i] += slope / information[i];
            }
        }
        double mean = Arrays.stream(strength).average().orElse(0);
        Map<SparringTeam, Rating> ratings = new LinkedHashMap<>();
        for (int i = 0; i < teams.length; i++) {
            ratings.put(teams[i], new Rating(POINTS * (strength[i] - mean), POINTS / Math.sqrt(information[i])));
        }
        return ratings;
    }
}
