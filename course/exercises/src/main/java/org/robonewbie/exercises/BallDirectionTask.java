package org.robonewbie.exercises;

import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.robonewbie.nao.Joint;
import org.robonewbie.nao.Vector3;
import org.robonewbie.nao.geometry.Pose2d;
import org.robonewbie.nao.kinematics.BodyState;
import org.robonewbie.nao.kinematics.ForwardKinematics;
import org.robonewbie.nao.model.RobotType;
import org.robonewbie.nao.motion.Keyframe;
import org.robonewbie.nao.motion.Motion;
import org.robonewbie.nao.motion.Posture;
import org.robonewbie.nao.motion.file.ShippedMotions;
import org.robonewbie.trial.RandomSource;
import org.robonewbie.trial.RobotStart;
import org.robonewbie.trial.Scene;
import org.robonewbie.trial.Trial;
import org.robonewbie.trial.WorldState;

/**
 * Task: report the direction of the ball while the head turns and the body leans. Neither adding the angles of the neck and
 * the camera nor using the forward kinematics of the neck, which assumes an upright torso, is accurate enough.
 */
final class BallDirectionTask implements Task {

    private static final Pose2d STUDENT = new Pose2d(-2, 0, 0);
    private static final Pattern WORDS = Pattern.compile("ball:(-?\\d{1,3}(\\.\\d+)?)");
    private static final double GOOD_DEGREES = 0.5;
    private static final double ANKLE_SHARE = 0.5;
    private static final int MIN_WORDS = 40;
    private static final double YAW_RANGE = 60;
    private static final double PITCH_RANGE = 20;

    private static final Vector3 HEAD =
            ForwardKinematics.of(RobotType.TYPE_0).camera(0, 0).position();

    private Optional<String> said = Optional.empty();
    private double lowYaw = 180;
    private double highYaw = -180;
    private double lowPitch = 180;
    private double highPitch = -180;
    private double sumOfErrors;
    private int words;

    @Override
    public Scene scene(RandomSource random) {
        double lean = random.between(14, 20);
        double bearing = random.side() * random.between(20, 40);
        return Scene.of(RobotStart.at(STUDENT).after(ShippedMotions.motion("stand"), leaning(lean)))
                .withBall(STUDENT.point(random.between(1, 2), bearing, 0));
    }

    /** Returns a motion that leans forward at the hips; the ankles keep the centre of mass above the feet. */
    private static Motion leaning(double degrees) {
        double hip = 35 + (1 + ANKLE_SHARE) * degrees;
        double ankle = 37 - ANKLE_SHARE * degrees;
        Posture leaning = Posture.ZERO
                .with(Joint.LEFT_HIP_PITCH, hip)
                .with(Joint.RIGHT_HIP_PITCH, hip)
                .with(Joint.LEFT_KNEE_PITCH, -70)
                .with(Joint.RIGHT_KNEE_PITCH, -70)
                .with(Joint.LEFT_FOOT_PITCH, ankle)
                .with(Joint.RIGHT_FOOT_PITCH, ankle)
                .with(Joint.LEFT_SHOULDER_PITCH, -95)
                .with(Joint.RIGHT_SHOULDER_PITCH, -95);
        return new Motion("lean", List.of(new Keyframe(800, leaning), new Keyframe(600, leaning)));
    }

    @Override
    public void act(Trial trial) {
        said = trial.said(0);
    }

    @Override
    public void see(WorldState state) {
        BodyState robot = state.robot();
        lowYaw = Math.min(lowYaw, robot.degrees(Joint.NECK_YAW));
        highYaw = Math.max(highYaw, robot.degrees(Joint.NECK_YAW));
        lowPitch = Math.min(lowPitch, robot.degrees(Joint.NECK_PITCH));
        highPitch = Math.max(highPitch, robot.degrees(Joint.NECK_PITCH));
        said.map(WORDS::matcher).filter(Matcher::matches).ifPresent(match -> {
            words++;
            sumOfErrors += Math.abs(Double.parseDouble(match.group(1)) - bearing(state));
        });
    }

    /** Returns the bearing of the ball from the ground point below the head, relative to the heading of the torso. */
    private static double bearing(WorldState state) {
        BodyState robot = state.robot();
        Vector3 head = robot.torso().transform(HEAD);
        return new Pose2d(head.x(), head.y(), robot.headingDegrees()).bearing(state.ball());
    }

    @Override
    public Score score() {
        double error = sumOfErrors / Math.max(1, words);
        String finding = words == 0
                ? "said nothing"
                : String.format(Locale.ROOT, "said the direction %d times, mean error %.2f°", words, error);
        if (words < MIN_WORDS) {
            return Score.failed(
                    0,
                    finding,
                    "Say the direction at least 40 times while the ball is visible, for example with"
                            + " nao.say(\"ball:-12.3\").");
        }
        if (highYaw - lowYaw < YAW_RANGE || highPitch - lowPitch < PITCH_RANGE) {
            return Score.failed(2, finding, "The head must move: call lookAround.look() in each cycle.");
        }
        return error <= GOOD_DEGREES
                ? Score.passed(finding)
                : Score.failed(
                        5 - error,
                        finding,
                        "CameraTransformation.KINEMATICS follows the neck exactly but assumes that the torso is"
                                + " upright. How far does it lean? At rest, the accelerometer vector points up:"
                                + " rotate the point so that this vector becomes (0, 0, 1).");
    }
}
