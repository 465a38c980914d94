package org.robonewbie.exercises;

import java.util.Locale;
import org.robonewbie.nao.Joint;
import org.robonewbie.nao.Vector3;
import org.robonewbie.trial.Chance;
import org.robonewbie.trial.Moment;
import org.robonewbie.trial.Place;
import org.robonewbie.trial.RobotStart;
import org.robonewbie.trial.Scene;
import org.robonewbie.trial.measure.Held;

/** Three things in sequence: walk to the ball, stop in front of it, raise the arm. The ball must not be touched. */
final class GoToTheBallTask implements Task {

    private static final double NEAR_METRES = 0.5;
    private static final double FACING_DEGREES = 20;
    private static final double MOVED_METRES = 0.02;
    private static final double UP_DEGREES = 60;
    private static final double HELD_SECONDS = 1;

    private Vector3 ballStart = Vector3.ZERO;
    private double nearest = Double.POSITIVE_INFINITY;
    private double moved;
    private boolean fallen;
    private final Held done = new Held(HELD_SECONDS, GoToTheBallTask::isDone);

    @Override
    public Scene scene(Chance chance) {
        Place start = new Place(-2.5, chance.between(-1, 1), chance.between(-60, 60));
        return Scene.of(RobotStart.at(start).after("stand"))
                .withBall(start.point(chance.between(1.5, 2.5), chance.between(-50, 50), 0));
    }

    @Override
    public void see(Moment moment) {
        ballStart = moment.seconds() == 0 ? moment.ball() : ballStart;
        moved = Math.max(moved, moment.ball().distanceTo(ballStart));
        fallen |= moment.robot().isFallen();
        nearest = Math.min(nearest, moment.place().distance(moment.ball()));
        done.see(moment);
    }

    private static boolean isDone(Moment moment) {
        return moment.place().distance(moment.ball()) <= NEAR_METRES
                && Math.abs(moment.place().bearing(moment.ball())) <= FACING_DEGREES
                && moment.robot().degrees(Joint.LEFT_SHOULDER_PITCH) >= UP_DEGREES;
    }

    @Override
    public boolean isDecided() {
        return done.isDecided() || moved > MOVED_METRES;
    }

    @Override
    public Score score() {
        String finding = String.format(
                Locale.ROOT, "nearest %.2f m, ball moved by %.3f m%s", nearest, moved, fallen ? ", and a fall" : "");
        if (moved > MOVED_METRES) {
            return Score.failed(
                    3,
                    finding,
                    "The feet reach further ahead than the torso: stop when fieldView.ball().distance() is 0.4 m, and get"
                            + " slower before.");
        }
        if (!done.isDecided()) {
            return Score.failed(
                    nearest <= NEAR_METRES ? 4 : 1,
                    finding,
                    "Within 0.5 m of the ball and facing it, the left shoulder must be above 60° for 1 s.");
        }
        return Score.passed(String.format(Locale.ROOT, "%s, done after %.1f s", finding, done.value()));
    }
}
