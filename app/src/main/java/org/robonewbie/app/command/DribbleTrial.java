package org.robonewbie.app.command;

import org.robonewbie.nao.Vector3;
import org.robonewbie.nao.model.RobotType;
import org.robonewbie.team.skill.CloseDribbleNumbers;
import org.robonewbie.trial.Controller;
import org.robonewbie.trial.Scene;
import org.robonewbie.trial.Trial;
import org.robonewbie.trial.WorldState;

/**
 * A robot dribbles 5 m on the league's pitch, with noise, from the stance.
 *
 * @param seconds how long it took, infinite if it did not get there
 * @param metres how far the ball got ahead
 * @param farthest how far the ball was from the robot at most, metres
 * @param fell whether the robot lay on the ground at the end
 */
record DribbleTrial(double seconds, double metres, double farthest, boolean fell) {

    /** How far ahead of the robot the ball lies at first. */
    static final double BALL_AHEAD = 0.25;

    private static final double DRIBBLED_METRES = 5;
    private static final double MOST_SECONDS = 10;
    private static final double MOST_METRES = 0.5;

    /** When a dribbling is given up. */
    record Patience(double seconds, double farthest) {

        static final Patience LONG = new Patience(30, Double.POSITIVE_INFINITY);
        static final Patience SHORT = new Patience(12, 0.62);
    }

    /** Dribbles with a whole simulator. */
    static DribbleTrial served(RobotType type, CloseDribbleNumbers numbers, long seed) {
        try (Trial trial = Trial.served(
                PlayerChecks.scene(type, BALL_AHEAD, seed), seed, Controller.ofAgent(new Dribbler(numbers)))) {
            return run(trial, Patience.LONG);
        }
    }

    /** Dribbles in the physical world alone, and gives up soon. */
    static DribbleTrial direct(CloseDribbleNumbers numbers, long seed) {
        Scene scene = PlayerChecks.scene(RobotType.TYPE_0, BALL_AHEAD, seed);
        try (Trial trial = Trial.direct(scene, seed, Controller.ofAgent(new Dribbler(numbers)))) {
            return run(trial, Patience.SHORT);
        }
    }

    private static DribbleTrial run(Trial trial, Patience patience) {
        Vector3 begin = trial.now().ball();
        double farthest = 0;
        double metres = 0;
        while (metres < DRIBBLED_METRES && trial.seconds() < patience.seconds && farthest < patience.farthest) {
            WorldState now = trial.step();
            farthest = Math.max(farthest, now.place().distance(now.ball()));
            metres = now.ball().x() - begin.x();
        }
        double seconds = metres < DRIBBLED_METRES ? Double.POSITIVE_INFINITY : trial.seconds();
        return new DribbleTrial(seconds, metres, farthest, trial.robot(0).isFallen());
    }

    /** Whether the ball was 5 m ahead within 10 s. */
    boolean isInTime() {
        return seconds <= MOST_SECONDS;
    }

    /** Whether it was, and never further away than 0.5 m. */
    boolean isClose() {
        return isInTime() && farthest <= MOST_METRES;
    }

    /** What a search pays for it: seconds, and what is beyond the limits. A dribbling that was given up costs the more the sooner it was. */
    double cost() {
        if (Double.isInfinite(seconds)) {
            return 6 + 8 * (1 - Math.max(0, metres) / DRIBBLED_METRES) + (fell ? 1 : 0);
        }
        return 0.1 * seconds
                + 1.5 * Math.max(0, seconds - 9.3)
                + 12 * Math.max(0, farthest - 0.44)
                + (isInTime() ? 0 : 1.5)
                + (farthest <= MOST_METRES ? 0 : 1.5);
    }
}
