package org.robonewbie.competition.contest;

import java.util.List;

/** All contests with their usual values. */
public final class Contests {

    /** Simulated seconds of a scoring trial: three minutes. */
    public static final double SCORING_SECONDS = 180;

    private static final double MINI_SECONDS = 60;
    private static final double RACE_METRES = 3;

    private Contests() {}

    /**
     * The paper's competition: who scores first.
     *
     * @param conditions seeds and variations
     * @param seconds simulated seconds of a trial
     * @return the contest
     */
    public static JudgedContest scoring(Conditions conditions, double seconds) {
        return new SoloContest(
                "scoring",
                "Scoring",
                "One trial of " + Math.round(seconds)
                        + " s for each team. Who scores first is first; those who do not score are ranked by how near"
                        + " the ball came to the goal.",
                new StartPlace(2, -0.5, 0.4, -40),
                seconds,
                trial -> new GoalJudge(trial, trial.entrants().get(0).team()),
                List.of(
                        new Criterion(GoalJudge.GOAL_SECONDS, "Goal after", "%.2f s", false),
                        new Criterion(GoalJudge.BALL_METRES, "Ball to goal", "%.3f m", false)),
                conditions);
    }

    /**
     * A penalty shoot-out.
     *
     * @param conditions seeds
     * @param rounds rounds that are played in any case
     * @param seconds simulated seconds that an attacker has
     * @return the contest
     */
    public static JudgedContest penalties(Conditions conditions, int rounds, double seconds) {
        return new PenaltyContest(new ShootOut(rounds, 5), seconds, conditions);
    }

    /**
     * A race.
     *
     * @param conditions seeds and variations
     * @return the contest
     */
    public static JudgedContest walk(Conditions conditions) {
        return new SoloContest(
                "walk",
                "Fastest walk",
                "3 m straight ahead towards the ball. The first to cross the line upright wins; those who do not cross"
                        + " it are ranked by their way.",
                new StartPlace(2, -4, 0, 0),
                MINI_SECONDS,
                trial -> new WalkJudge(trial, RACE_METRES),
                List.of(
                        new Criterion(WalkJudge.LINE_SECONDS, "Line after", "%.2f s", false),
                        new Criterion(WalkJudge.WAY_METRES, "Way", "%.2f m", true)),
                conditions);
    }

    /**
     * A contest of kicks.
     *
     * @param conditions seeds and variations
     * @return the contest
     */
    public static JudgedContest kick(Conditions conditions) {
        return new SoloContest(
                "kick",
                "Longest kick",
                "The ball lies on the centre spot, the robot starts 0.8 m behind it and has 60 s. What counts is how"
                        + " far the ball gets from the place where it left the robot.",
                new StartPlace(2, -0.8, 0, 0),
                MINI_SECONDS,
                KickJudge::new,
                List.of(new Criterion(KickJudge.KICK_METRES, "Kick", "%.2f m", true)),
                conditions);
    }

    /**
     * A contest of standing firm against pushes.
     *
     * @param conditions seeds and variations
     * @return the contest
     */
    public static JudgedContest stand(Conditions conditions) {
        return new SoloContest(
                "stand",
                "Longest standing",
                "The robot is pushed every 3 s for 0.1 s, from changing directions, each time 5 N harder. Who lies"
                        + " last wins.",
                new StartPlace(2, -2, 0, 0),
                SCORING_SECONDS,
                trial -> new PushJudge(trial, conditions.seed()),
                List.of(
                        new Criterion(PushJudge.STANDING_SECONDS, "Stood for", "%.2f s", true),
                        new Criterion(PushJudge.PUSHES, "Pushes survived", "%.0f", true)),
                conditions);
    }

    /**
     * A contest of gymnastics.
     *
     * @param conditions seeds and variations
     * @return the contest
     */
    public static JudgedContest gymnastics(Conditions conditions) {
        return new SoloContest(
                "gymnastics",
                "Gymnastics",
                "60 s for six elements in any order: both arms up, a squat, a stand on one leg, a bow, a full turn,"
                        + " lying down and getting up. The most elements win, then the earliest last one.",
                new StartPlace(2, -2, 0, 0),
                MINI_SECONDS,
                GymnasticsJudge::new,
                List.of(
                        new Criterion(GymnasticsJudge.ELEMENTS, "Elements", "%.0f", true),
                        new Criterion(GymnasticsJudge.LAST_SECONDS, "Last one after", "%.2f s", false)),
                conditions);
    }
}
