package org.robonewbie.competition.contest;

import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.robonewbie.trial.measure.BallToGoal;
import org.robonewbie.trial.measure.LongestKick;
import org.robonewbie.trial.measure.Pushes;
import org.robonewbie.trial.measure.Race;
import org.robonewbie.trial.measure.Standing;

/** The contests of the competition. */
public final class Contests {

    /** Length of a trial in the scoring contest, in simulated seconds. */
    public static final double SCORING_SECONDS = 180;

    private static final double PENALTY_SECONDS = 30;
    private static final double MATCH_SECONDS = 300;
    private static final double MINI_SECONDS = 60;
    private static final double RACE_METRES = 3;
    private static final int CYCLES_BETWEEN_PUSHES = 150;
    private static final double PUSH_STEP_NEWTONS = 5;

    private Contests() {}

    /** {@return the contests with default options} */
    public static List<Contest> usual() {
        return all(Conditions.of(1), 3, 1, Optional.empty());
    }

    /**
     * Creates all contests.
     *
     * @param conditions seeds and variations
     * @param rounds rounds of a penalty shoot-out before sudden death
     * @param players robots per team in a match, 1 to 11
     * @param seconds length of a trial in simulated seconds, for contests with a configurable length; empty for the
     *     default length
     * @return the contests, with those for a single robot last
     */
    public static List<Contest> all(Conditions conditions, int rounds, int players, Optional<Double> seconds) {
        double matchSeconds = seconds.orElse(MATCH_SECONDS);
        return List.of(
                scoring(conditions, seconds.orElse(SCORING_SECONDS)),
                penalties(conditions, rounds, seconds.orElse(PENALTY_SECONDS)),
                new MatchContest(MatchKind.MATCHES, players, matchSeconds, conditions),
                new MatchContest(MatchKind.LEAGUE, players, matchSeconds, conditions),
                walk(conditions),
                kick(conditions),
                stand(conditions),
                gymnastics(conditions));
    }

    /**
     * Creates the scoring contest described in the RoboNewbie paper: the earliest goal wins.
     *
     * @param conditions seeds and variations
     * @param seconds length of a trial in simulated seconds
     * @return the contest
     */
    public static Contest scoring(Conditions conditions, double seconds) {
        String rule = "One trial of " + Math.round(seconds)
                + " s per team: the earliest goal wins; without a goal, the ball closest to the goal at the end.";
        StartPlace start = conditions.start(new StartPlace(2, -0.5, 0.4, -40));
        return new ChallengeContest(
                "scoring",
                "Scoring",
                rule,
                () -> new SoloChallenge<>(start, new BallToGoal(), Contests::goal),
                start,
                seconds,
                1,
                List.of(
                        Criterion.least("goalSeconds", "Goal after", "%.2f s"),
                        Criterion.least("ballMetres", "Ball to goal", "%.3f m"),
                        Criterion.least("closestMetres", "Closest", "%.3f m")),
                conditions);
    }

    private static Map<String, Double> goal(BallToGoal ball) {
        Map<String, Double> figures =
                new HashMap<>(Map.of("ballMetres", ball.lastMetres(), "closestMetres", ball.value()));
        if (ball.isDecided()) {
            figures.put("goalSeconds", ball.seconds());
        }
        return figures;
    }

    /**
     * Creates a contest of penalty shoot-outs.
     *
     * @param conditions seeds
     * @param rounds number of regular rounds
     * @param seconds time limit of an attack in simulated seconds
     * @return the contest
     */
    public static JudgedContest penalties(Conditions conditions, int rounds, double seconds) {
        return new PenaltyContest(new ShootOut(rounds, 5), seconds, conditions);
    }

    /**
     * Creates a walking race.
     *
     * @param conditions seeds and variations
     * @return the contest
     */
    public static Contest walk(Conditions conditions) {
        StartPlace start = conditions.start(new StartPlace(2, -4, 0, 0));
        return new ChallengeContest(
                "walk",
                "Fastest walk",
                "Walk 3 m straight ahead within 60 s. The fastest robot to cross the line upright wins; robots that do not"
                        + " cross it are ranked by the distance walked.",
                () -> new SoloChallenge<>(start, new Race(RACE_METRES), Contests::way),
                start,
                MINI_SECONDS,
                1,
                List.of(
                        Criterion.least("lineSeconds", "Line after", "%.2f s"),
                        Criterion.most("wayMetres", "Way", "%.2f m")),
                conditions);
    }

    private static Map<String, Double> way(Race race) {
        return race.isDecided()
                ? Map.of("lineSeconds", race.value(), "wayMetres", race.metres())
                : Map.of("wayMetres", race.metres());
    }

    /**
     * Creates a kicking contest.
     *
     * @param conditions seeds and variations
     * @return the contest
     */
    public static Contest kick(Conditions conditions) {
        StartPlace start = conditions.start(new StartPlace(2, -0.8, 0, 0));
        return new ChallengeContest(
                "kick",
                "Longest kick",
                "Kick the ball as far as possible within 60 s. The distance is measured from where the ball left the robot.",
                () -> new SoloChallenge<>(start, new LongestKick(), kick -> Map.of("kickMetres", kick.value())),
                start,
                MINI_SECONDS,
                1,
                List.of(Criterion.most("kickMetres", "Kick", "%.2f m")),
                conditions);
    }

    /**
     * Creates a contest in which robots keep their balance while being pushed.
     *
     * @param conditions seeds and variations
     * @return the contest
     */
    public static Contest stand(Conditions conditions) {
        StartPlace start = conditions.start(new StartPlace(2, -2, 0, 0));
        return new ChallengeContest(
                "stand",
                "Longest standing",
                "A push of 0.1 s every 3 s, from varying directions, each 5 N harder. The last robot standing wins.",
                () -> pushed(start, conditions.seed()),
                start,
                SCORING_SECONDS,
                1,
                List.of(
                        Criterion.most("standingSeconds", "Stood for", "%.2f s"),
                        Criterion.most("pushes", "Pushes survived", "%.0f")),
                conditions);
    }

    private static SoloChallenge<Standing> pushed(StartPlace start, long seed) {
        Pushes pushes = Pushes.growing(seed, CYCLES_BETWEEN_PUSHES, PUSH_STEP_NEWTONS);
        return new SoloChallenge<>(
                start,
                new Standing(),
                pushes,
                standing -> Map.of(
                        "standingSeconds", standing.value(), "pushes", (double) Math.max(0, pushes.count() - 1)));
    }

    /**
     * Creates a gymnastics contest.
     *
     * @param conditions seeds and variations
     * @return the contest
     */
    public static Contest gymnastics(Conditions conditions) {
        StartPlace start = conditions.start(new StartPlace(2, -2, 0, 0));
        return new ChallengeContest(
                "gymnastics",
                "Gymnastics",
                "60 s for six elements in any order: both arms up, a squat, a stand on one leg, a bow, a full turn, lying"
                        + " down and getting up. The most elements win; in a tie, the team that completed its last element earlier.",
                () -> new SoloChallenge<>(start, new Gymnastics(), Gymnastics::figures),
                start,
                MINI_SECONDS,
                1,
                List.of(
                        Criterion.most("elements", "Elements", "%.0f"),
                        Criterion.least("lastSeconds", "Last one after", "%.2f s")),
                conditions);
    }
}
