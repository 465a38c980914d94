package org.robonewbie.workshop.team;

import org.robonewbie.nao.Vector3;
import org.robonewbie.nao.model.RobotType;
import org.robonewbie.team.skill.CloseDribbleNumbers;
import org.robonewbie.trial.Controller;
import org.robonewbie.trial.Trial;
import org.robonewbie.trial.WorldState;

/**
 * Trial in which a robot, starting in its standard stance, dribbles 5 m on the league pitch with noise.
 *
 * @param seconds duration in seconds; infinite if the robot did not arrive
 * @param farthest maximum distance between the ball and the robot in metres
 */
record DribbleTrial(double seconds, double farthest) {

    /** Initial distance in metres from the robot to the ball ahead of it. */
    static final double BALL_AHEAD = 0.25;

    private static final double DRIBBLED_METRES = 5;
    private static final double MAX_SECONDS = 10;
    private static final double GIVE_UP_SECONDS = 30;
    private static final double MAX_METRES = 0.5;

    /** Runs a trial in a full simulator. */
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

    /** Returns whether the ball had moved 5 m forward within 10 s. */
    boolean isInTime() {
        return seconds <= MAX_SECONDS;
    }

    /** Returns whether the trial succeeded and the ball was never more than 0.5 m away from the robot. */
    boolean isClose() {
        return isInTime() && farthest <= MAX_METRES;
    }
}
