package org.robonewbie.workshop.team;

import org.robonewbie.nao.Vector3;
import org.robonewbie.nao.model.RobotType;
import org.robonewbie.team.skill.CloseDribbleNumbers;
import org.robonewbie.trial.Controller;
import org.robonewbie.trial.Trial;
import org.robonewbie.trial.WorldState;

/**
 * A robot dribbles 5 m on the league's pitch, with noise, from the stance.
 *
 * @param seconds how long it took, infinite if it did not get there
 * @param farthest how far the ball was from the robot at most, metres
 */
record DribbleTrial(double seconds, double farthest) {

    /** How far ahead of the robot the ball lies at first. */
    static final double BALL_AHEAD = 0.25;

    private static final double DRIBBLED_METRES = 5;
    private static final double MOST_SECONDS = 10;
    private static final double GIVE_UP_SECONDS = 30;
    private static final double MOST_METRES = 0.5;

    /** Dribbles with a whole simulator. */
    static DribbleTrial served(RobotType type, CloseDribbleNumbers numbers, long seed) {
        try (Trial trial = Trial.served(
                PlayerChecks.scene(type, BALL_AHEAD, seed), seed, Controller.ofAgent(new Dribbler(numbers)))) {
            return run(trial);
        }
    }

    private static DribbleTrial run(Trial trial) {
        Vector3 begin = trial.now().ball();
        double farthest = 0;
        double metres = 0;
        while (metres < DRIBBLED_METRES && trial.seconds() < GIVE_UP_SECONDS) {
            WorldState now = trial.step();
            farthest = Math.max(farthest, now.place().distance(now.ball()));
            metres = now.ball().x() - begin.x();
        }
        double seconds = metres < DRIBBLED_METRES ? Double.POSITIVE_INFINITY : trial.seconds();
        return new DribbleTrial(seconds, farthest);
    }

    /** Whether the ball was 5 m ahead within 10 s. */
    boolean isInTime() {
        return seconds <= MOST_SECONDS;
    }

    /** Whether it was, and never further away than 0.5 m. */
    boolean isClose() {
        return isInTime() && farthest <= MOST_METRES;
    }
}
