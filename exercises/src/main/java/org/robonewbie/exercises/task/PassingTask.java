package org.robonewbie.exercises.task;

import java.util.Locale;
import org.robonewbie.exercises.Score;
import org.robonewbie.exercises.Task;
import org.robonewbie.nao.Vector3;
import org.robonewbie.trial.Chance;
import org.robonewbie.trial.Moment;
import org.robonewbie.trial.Place;
import org.robonewbie.trial.RobotStart;
import org.robonewbie.trial.Scene;
import org.robonewbie.trial.Trial;

/**
 * Two robots of the student: number 1 plays the ball, number 2 comes to meet it.
 */
public final class PassingTask implements Task {

    private static final Place PASSER = new Place(-2, 0, 0);
    private static final double BALL_AHEAD = 0.187;
    private static final double BALL_LEFT = 0.063;
    private static final double FEWEST_METRES = 1;
    private static final double AT_MATE_METRES = 0.45;

    private Vector3 ballStart = Vector3.ZERO;
    private double metres;
    private double nearest = Double.POSITIVE_INFINITY;
    private boolean fallen;

    /** Creates the task of one trial. */
    public PassingTask() {}

    @Override
    public Scene scene(Chance chance) {
        Place mate = new Place(0.6 + chance.between(0, 0.3), chance.between(-0.5, 0.5), 180);
        return Scene.of(
                        RobotStart.at(PASSER).after("stand"),
                        RobotStart.at(mate).withTeam(RobotStart.TEAM, 2))
                .withBall(4, 3);
    }

    @Override
    public void begin(Trial trial) {
        trial.placeBall(trial.now().place().pointAt(BALL_AHEAD, BALL_LEFT));
        ballStart = trial.ball().position();
    }

    @Override
    public void see(Moment moment) {
        metres = Math.max(metres, moment.ball().distanceTo(ballStart));
        if (metres >= FEWEST_METRES) {
            nearest = Math.min(nearest, moment.place(1).distance(moment.ball()));
        }
        fallen |= moment.robots().get(1).isFallen() || moment.robot().isFallen();
    }

    @Override
    public boolean isDecided() {
        return nearest <= AT_MATE_METRES;
    }

    @Override
    public Score score() {
        String finding = String.format(
                Locale.ROOT,
                "the ball went %.2f m, number 2 came as near as %.2f m%s",
                metres,
                nearest,
                fallen ? ", and a fall" : "");
        return nearest <= AT_MATE_METRES && !fallen
                ? Score.passed(finding)
                : Score.failed(
                        metres >= FEWEST_METRES ? 5 : 1,
                        finding,
                        "Both robots run your program: ask nao.getNumber(). Number 1 plays \"pass-left\", number 2 walks to the"
                                + " ball as soon as it rolls.");
    }
}
