package org.robonewbie.exercises.task;

import java.util.Locale;
import java.util.Optional;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.robonewbie.exercises.Score;
import org.robonewbie.exercises.Task;
import org.robonewbie.nao.Joint;
import org.robonewbie.nao.kinematics.BodyState;
import org.robonewbie.trial.Chance;
import org.robonewbie.trial.Moment;
import org.robonewbie.trial.Place;
import org.robonewbie.trial.RobotStart;
import org.robonewbie.trial.Scene;
import org.robonewbie.trial.Trial;

/** Report where the ball is while the head turns: the simple sum of neck and camera angles is not exact enough. */
public final class BallDirectionTask implements Task {

    private static final Place STUDENT = new Place(-2, 0, 0);
    private static final Pattern WORDS = Pattern.compile("ball:(-?\\d{1,3}(\\.\\d+)?)");
    private static final double GOOD_DEGREES = 0.4;
    private static final int FEWEST_WORDS = 40;
    private static final double YAW_RANGE = 60;
    private static final double PITCH_RANGE = 20;

    private Optional<String> said = Optional.empty();
    private double lowYaw = 180;
    private double highYaw = -180;
    private double lowPitch = 180;
    private double highPitch = -180;
    private double sumOfErrors;
    private int words;

    /** Creates the task of one trial. */
    public BallDirectionTask() {}

    @Override
    public Scene scene(Chance chance) {
        return Scene.of(RobotStart.at(STUDENT))
                .withBall(STUDENT.point(chance.between(1, 2), chance.between(-35, 35), 0));
    }

    @Override
    public void act(Trial trial) {
        said = trial.said(0);
    }

    @Override
    public void see(Moment moment) {
        BodyState robot = moment.robot();
        lowYaw = Math.min(lowYaw, robot.degrees(Joint.NECK_YAW));
        highYaw = Math.max(highYaw, robot.degrees(Joint.NECK_YAW));
        lowPitch = Math.min(lowPitch, robot.degrees(Joint.NECK_PITCH));
        highPitch = Math.max(highPitch, robot.degrees(Joint.NECK_PITCH));
        said.map(WORDS::matcher).filter(Matcher::matches).ifPresent(match -> {
            words++;
            sumOfErrors +=
                    Math.abs(Double.parseDouble(match.group(1)) - moment.place().bearing(moment.ball()));
        });
    }

    @Override
    public Score score() {
        double error = sumOfErrors / Math.max(1, words);
        String finding = String.format(Locale.ROOT, "told %d times, mean error %.2f°", words, error);
        if (words < FEWEST_WORDS) {
            return Score.failed(
                    0, finding, "Say it at least 40 times, such as nao.say(\"ball:-12.3\"), when the ball is visible.");
        }
        if (highYaw - lowYaw < YAW_RANGE || highPitch - lowPitch < PITCH_RANGE) {
            return Score.failed(2, finding, "The head must move: call lookAround.look() in each cycle.");
        }
        return error <= GOOD_DEGREES
                ? Score.passed(finding)
                : Score.failed(
                        8 - error,
                        finding,
                        "Adding angles is right only while the head is level. Turn the point by pitch, then by yaw, or choose"
                                + " CameraTransformation.KINEMATICS.");
    }
}
