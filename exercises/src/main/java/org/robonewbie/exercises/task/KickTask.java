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
 * Kick a ball that lies before the left foot. Walking through it does not count.
 */
public final class KickTask implements Task {

    private static final Place STUDENT = new Place(-3, 0, 0);
    private static final double FAR_METRES = 2;
    private static final double STAYED_METRES = 0.4;
    private static final double BALL_AHEAD = 0.209;
    private static final double BALL_LEFT = 0.036;
    private static final double ERROR_METRES = 0.006;

    private Vector3 ballStart = Vector3.ZERO;
    private Vector3 robotStart = Vector3.ZERO;
    private double ahead;
    private double left;
    private double metres;
    private double walked;
    private boolean fallen;
    private boolean standing;

    /** Creates the task of one trial. */
    public KickTask() {}

    @Override
    public Scene scene(Chance chance) {
        ahead = BALL_AHEAD + chance.between(-ERROR_METRES, ERROR_METRES);
        left = BALL_LEFT + chance.between(-ERROR_METRES, ERROR_METRES);
        return Scene.of(RobotStart.at(STUDENT).after("stand")).withBall(4, 3);
    }

    @Override
    public void begin(Trial trial) {
        trial.placeBall(trial.now().place().pointAt(ahead, left));
        ballStart = trial.ball().position();
        robotStart = trial.now().robot().position();
    }

    @Override
    public void see(Moment moment) {
        metres = Math.max(metres, moment.ball().x() - ballStart.x());
        walked = Math.max(walked, moment.place().distance(robotStart));
        fallen |= moment.robot().isFallen();
        standing = moment.robot().isStanding();
    }

    @Override
    public Score score() {
        String finding = String.format(
                Locale.ROOT,
                "the ball went %.2f m, the robot moved %.2f m%s",
                metres,
                walked,
                fallen ? " and fell" : "");
        if (fallen || !standing) {
            return Score.failed(2 * metres, finding, "Shift the weight onto the other foot before the leg swings.");
        }
        if (walked > STAYED_METRES) {
            return Score.failed(2, finding, "Kick from where you stand: that was a walk.");
        }
        return metres >= FAR_METRES
                ? Score.passed(
                        (int) Math.round(7 + metres - FAR_METRES), finding, metres < 5 ? "10 points are for 5 m." : "")
                : Score.failed(
                        4 * metres, finding, "The foot must be quick where the ball lies: a short keyframe there.");
    }
}
