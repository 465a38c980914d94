package org.robonewbie.exercises.task;

import java.util.Locale;
import org.robonewbie.exercises.Score;
import org.robonewbie.exercises.Task;
import org.robonewbie.nao.Joint;
import org.robonewbie.nao.kinematics.BodyState;
import org.robonewbie.trial.Chance;
import org.robonewbie.trial.Moment;
import org.robonewbie.trial.RobotStart;
import org.robonewbie.trial.Scene;

/**
 * Raise the left arm to 60° and the right arm to 45°; the last half second counts.
 */
public final class RaiseArmsTask implements Task {

    private static final double LEFT_DEGREES = 60;
    private static final double RIGHT_DEGREES = 45;
    private static final double TOLERANCE_DEGREES = 2;
    private static final double JUDGED_FROM_SECONDS = 3.5;

    private double leftError;
    private double rightError;

    /** Creates the task of one trial. */
    public RaiseArmsTask() {}

    @Override
    public Scene scene(Chance chance) {
        return Scene.of(RobotStart.at(-1, 0));
    }

    @Override
    public void see(Moment moment) {
        if (moment.seconds() > JUDGED_FROM_SECONDS) {
            BodyState robot = moment.robot();
            leftError = Math.max(leftError, Math.abs(robot.degrees(Joint.LEFT_SHOULDER_PITCH) - LEFT_DEGREES));
            rightError = Math.max(rightError, Math.abs(robot.degrees(Joint.RIGHT_SHOULDER_PITCH) - RIGHT_DEGREES));
        }
    }

    @Override
    public Score score() {
        String finding = String.format(
                Locale.ROOT, "left arm %.1f° off, right arm %.1f° off (2° are allowed)", leftError, rightError);
        boolean left = leftError <= TOLERANCE_DEGREES;
        boolean right = rightError <= TOLERANCE_DEGREES;
        return left && right
                ? Score.passed(finding)
                : Score.failed(
                        left || right ? 5 : 0,
                        finding,
                        "Give each shoulder its own speed, and 0 when its angle is reached. Slow is exact.");
    }
}
