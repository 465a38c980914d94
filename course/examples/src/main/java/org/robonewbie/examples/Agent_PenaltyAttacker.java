package org.robonewbie.examples;

import java.io.IOException;
import java.io.UncheckedIOException;
import org.robonewbie.agent.Options;
import org.robonewbie.nao.Vector3;
import org.robonewbie.nao.geometry.Translation2d;
import org.robonewbie.nao.motion.MotionFile;
import org.robonewbie.nao.motion.file.MotionFiles;

/**
 * A penalty taker: it gets behind the ball as {@link Agent_BetterSoccer} does, but then kicks it hard instead of pushing it.
 *
 * <p>A kick requires precision. The robot stops with the ball right in front of a foot, stands still, checks the ball's
 * position again, and only then plays the motion. The comment {@code // ball:} in the motion file specifies the required
 * position. The robot sees the ball in the frame of its head; the accelerometer measures the tilt, which is needed to convert
 * the position to the frame of its torso.
 *
 * <p>Start {@link Agent_PenaltyGoalkeeper} in the same simulator. Ideas: aim at the corner that the goalkeeper leaves open.
 */
public final class Agent_PenaltyAttacker extends Agent_BetterSoccer {

    private static final double NEAR_METRES = 0.45;
    private static final double GOOD_METRES = 0.012;
    private static final double FAIR_METRES = 0.02;
    private static final double GOOD_DEGREES = 8;
    private static final double STILL_SECONDS = 0.5;
    private static final double PATIENCE_SECONDS = 8;
    private static final double HEAD_ABOVE_TORSO_METRES = 0.155;

    private final Translation2d ballBeforeKick = ballBeforeKick();
    private double leanDegrees;
    private double stoppedSeconds;
    private double nearSeconds;

    /** Creates the agent. */
    public Agent_PenaltyAttacker() {}

    /**
     * Starts the robot.
     *
     * @param args options such as {@code --headless}; {@code --help} lists them
     */
    public static void main(String[] args) {
        new Agent_PenaltyAttacker().run(args);
    }

    @Override
    protected Options defaults() {
        return Options.none().withTeam("Attackers").withNumber(2).withPose(-0.8, 0, 0);
    }

    @Override
    protected void bring(Vector3 ball, Vector3 goal) {
        double measuredDegrees =
                Math.toDegrees(Math.asin(limited(-nao.getAcceleration().x() / 9.81, 0.3)));
        leanDegrees += 0.1 * (measuredDegrees - leanDegrees); // smoothed, because each step shakes the robot
        Vector3 place = fromTorso(ball);
        double turn = Math.toDegrees(Math.atan2(goal.y() - ball.y(), goal.x() - ball.x()));
        if (Math.hypot(place.x(), place.y()) > NEAR_METRES || Math.abs(turn) > 40 || place.x() < 0.05) {
            nearSeconds = nao.getTime();
            super.bring(ball, goal);
        } else {
            prepareKick(place, turn);
        }
    }

    /** Steps into position and kicks. */
    private void prepareKick(Vector3 ball, double turn) {
        boolean left = ball.y() > 0;
        double forward = ball.x() - ballBeforeKick.x();
        double aside = ball.y() - (left ? ballBeforeKick.y() : -ballBeforeKick.y());
        boolean patient = nao.getTime() - nearSeconds < PATIENCE_SECONDS;
        double tolerance = patient ? GOOD_METRES : FAIR_METRES;
        boolean good = Math.abs(forward) < tolerance && Math.abs(aside) < tolerance && Math.abs(turn) < GOOD_DEGREES;
        if (walk.isWalking()) {
            stoppedSeconds = nao.getTime();
        }
        boolean still = nao.getTime() - stoppedSeconds > STILL_SECONDS;
        if (good && still) {
            motions.start(left ? "kick-left" : "kick-right");
            nearSeconds = nao.getTime();
        } else if (good) {
            walk.stop();
        } else if (still || walk.isWalking()) {
            walk.towards(limited(forward, 0.1), limited(aside, 0.08), turn);
        }
    }

    /** Converts a position from the head's frame to a horizontal frame whose origin is below the torso. */
    private Vector3 fromTorso(Vector3 ball) {
        double lean = Math.toRadians(leanDegrees);
        double up = ball.z() + HEAD_ABOVE_TORSO_METRES;
        return new Vector3(ball.x() * Math.cos(lean) + up * Math.sin(lean), ball.y(), 0);
    }

    /** Returns the ball position required for a kick with the left foot. */
    private static Translation2d ballBeforeKick() {
        try {
            return MotionFiles.library()
                    .find("kick-left")
                    .flatMap(MotionFile::ball)
                    .orElse(new Translation2d(0.19, 0.055));
        } catch (IOException unreadable) {
            throw new UncheckedIOException(unreadable);
        }
    }

    private static double limited(double value, double most) {
        return Math.max(-most, Math.min(most, value));
    }
}
