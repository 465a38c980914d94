package org.robonewbie.exercises;

import java.util.Locale;
import java.util.Optional;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.robonewbie.nao.Joint;
import org.robonewbie.nao.geometry.Pose2d;
import org.robonewbie.nao.kinematics.BodyState;
import org.robonewbie.trial.RandomSource;
import org.robonewbie.trial.RobotStart;
import org.robonewbie.trial.Scene;
import org.robonewbie.trial.Trial;
import org.robonewbie.trial.WorldState;

/** Task: turn away from a stationary ball and keep reporting its bearing. */
final class UnseenBallTask implements Task {

    private static final Pose2d STUDENT = new Pose2d(-2, 0, 0);
    private static final Pattern WORDS = Pattern.compile("ball:(-?\\d{1,3}(\\.\\d+)?)");
    private static final double UNSEEN_DEGREES = 70;
    private static final double TURN_DEGREES = 150;
    private static final double STRAIGHT_DEGREES = 20;
    private static final double GOOD_DEGREES = 12;
    private static final int MIN_WORDS = 100;
    private static final double WORST_DEGREES = 60;

    private Optional<String> said = Optional.empty();
    private double turned;
    private double headTurned;
    private double sumOfErrors;
    private int words;
    private boolean fallen;

    @Override
    public Scene scene(RandomSource random) {
        return Scene.of(RobotStart.at(STUDENT).after("stand"))
                .withBall(STUDENT.point(random.between(1.2, 2.2), random.side() * random.between(5, 35), 0));
    }

    @Override
    public void act(Trial trial) {
        said = trial.said(0);
    }

    @Override
    public void see(WorldState state) {
        BodyState robot = state.robot();
        turned = Math.max(turned, Math.abs(robot.headingDegrees() - STUDENT.degrees()));
        headTurned = Math.max(headTurned, Math.abs(robot.degrees(Joint.NECK_YAW)));
        fallen |= robot.isFallen();
        double bearing = state.place().bearing(state.ball());
        if (Math.abs(bearing) > UNSEEN_DEGREES) {
            said.map(WORDS::matcher).filter(Matcher::matches).ifPresent(match -> {
                words++;
                double error = Math.abs(Double.parseDouble(match.group(1)) - bearing) % 360;
                sumOfErrors += Math.min(error, 360 - error);
            });
        }
    }

    @Override
    public Score score() {
        double error = sumOfErrors / Math.max(1, words);
        String finding = String.format(
                Locale.ROOT,
                "turned by %.0f°, reported the unseen ball %d times%s%s",
                turned,
                words,
                words == 0 ? "" : String.format(Locale.ROOT, ", mean error %.1f°", error),
                fallen ? ", and fell" : "");
        if (turned < TURN_DEGREES || fallen) {
            return Score.failed(
                    1, finding, "Turn on the spot with walk.towards(0, 0, 30) until the ball is behind you.");
        }
        if (headTurned > STRAIGHT_DEGREES) {
            return Score.failed(
                    1,
                    finding,
                    "The head must look straight ahead (NECK_YAW within 20°), so that the ball goes out"
                            + " of sight.");
        }
        if (words < MIN_WORDS) {
            return Score.failed(
                    2,
                    finding,
                    "Say the bearing in every cycle, even when the ball is out of sight, for example with"
                            + " nao.say(\"ball:-112.5\").");
        }
        return error <= GOOD_DEGREES
                ? Score.passed(finding)
                : Score.failed(
                        error > WORST_DEGREES ? 2 : 4,
                        finding,
                        "nao.getGyro().z() is your turning speed in degrees per second: while you turn"
                                + " left, the ball moves to the right at that rate. Add it up from the moment when"
                                + " the ball was last seen.");
    }
}
