package org.robonewbie.exercises;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import org.robonewbie.nao.Joint;
import org.robonewbie.nao.geometry.Pose2d;
import org.robonewbie.nao.kinematics.BodyState;
import org.robonewbie.nao.math.PortableMath;
import org.robonewbie.trial.RandomSource;
import org.robonewbie.trial.RobotStart;
import org.robonewbie.trial.Scene;
import org.robonewbie.trial.Trial;
import org.robonewbie.trial.WorldState;

/** Task: follow a moving ball with the head while swinging the left arm once every two seconds. */
final class TwoBehavioursTask implements Task {

    private static final Pose2d STUDENT = new Pose2d(-3, 0, 0);
    private static final double FROM_SECONDS = 3;
    private static final double AT_BALL_DEGREES = 15;
    private static final double SWING_DEGREES = 30;
    private static final double PERIOD_SECONDS = 2;

    private final List<Double> upward = new ArrayList<>();
    private double angleBefore;
    private double lowest;
    private double highest;
    private int cycles;
    private int atBall;

    @Override
    public Scene scene(RandomSource random) {
        return Scene.of(RobotStart.at(STUDENT)).withBall(STUDENT.point(1.5, 0, 0));
    }

    @Override
    public void act(Trial trial) {
        trial.placeBall(STUDENT.point(1.5, 45 * PortableMath.sin(2 * Math.PI * trial.seconds() / 6), 0));
    }

    @Override
    public void see(WorldState state) {
        BodyState robot = state.robot();
        double arm = robot.degrees(Joint.LEFT_SHOULDER_PITCH);
        if (state.seconds() > FROM_SECONDS) {
            cycles++;
            double gaze = robot.degrees(Joint.NECK_YAW);
            atBall += Math.abs(state.place().bearing(state.ball()) - gaze) < AT_BALL_DEGREES ? 1 : 0;
            lowest = Math.min(lowest, arm);
            highest = Math.max(highest, arm);
            if (angleBefore < 0 && arm >= 0) {
                upward.add(state.seconds());
            }
        }
        angleBefore = arm;
    }

    @Override
    public Score score() {
        double share = 100.0 * atBall / Math.max(1, cycles);
        boolean follows = share >= 80;
        double period =
                upward.size() < 2 ? Double.NaN : (upward.get(upward.size() - 1) - upward.get(0)) / (upward.size() - 1);
        boolean swings = Math.abs(period - PERIOD_SECONDS) < 0.1 && lowest < -SWING_DEGREES && highest > SWING_DEGREES;
        String finding = String.format(
                Locale.ROOT,
                "head turned to the ball for %.0f %% of the time, arm from %.0f° to %.0f°, %s",
                share,
                lowest,
                highest,
                Double.isNaN(period)
                        ? "fewer than two swings"
                        : String.format(Locale.ROOT, "once every %.2f s", period));
        return follows && swings
                ? Score.passed(finding)
                : Score.failed(
                        (follows ? 3 : 0) + (swings ? 3 : 0),
                        finding,
                        "Write two methods, each for its own joints, and call both in each think(). The arm moves"
                                + " from below -30° to above 30° and back in 2 s; the head turns to"
                                + " fieldView.ball().bearing().");
    }
}
