package org.robonewbie.exercises;

import java.util.Locale;
import org.robonewbie.nao.Joint;
import org.robonewbie.nao.kinematics.BodyState;
import org.robonewbie.trial.RandomSource;
import org.robonewbie.trial.RobotStart;
import org.robonewbie.trial.Scene;
import org.robonewbie.trial.WorldState;

/** Task: raise the left arm to 60° and the right arm to 45°; only the last half second counts. */
final class RaiseArmsTask implements Task {

    private static final double LEFT_DEGREES = 60;
    private static final double RIGHT_DEGREES = 45;
    private static final double TOLERANCE_DEGREES = 2;
    private static final double JUDGED_FROM_SECONDS = 3.5;

    private static final double AT_REST_DEGREES = 0.5;

    private final Arm left = new Arm(Joint.LEFT_SHOULDER_PITCH, LEFT_DEGREES);
    private final Arm right = new Arm(Joint.RIGHT_SHOULDER_PITCH, RIGHT_DEGREES);

    /** The largest error, with its sign, and the range of motion of one shoulder in the last half second. */
    private static final class Arm {
        private final Joint joint;
        private final double goal;
        private double error;
        private double lowest = Double.POSITIVE_INFINITY;
        private double highest = Double.NEGATIVE_INFINITY;

        Arm(Joint joint, double goal) {
            this.joint = joint;
            this.goal = goal;
        }

        void see(BodyState robot) {
            double degrees = robot.degrees(joint);
            error = Math.abs(degrees - goal) > Math.abs(error) ? degrees - goal : error;
            lowest = Math.min(lowest, degrees);
            highest = Math.max(highest, degrees);
        }

        boolean isRight() {
            return Math.abs(error) <= TOLERANCE_DEGREES;
        }

        @Override
        public String toString() {
            String place = isRight()
                    ? String.format(Locale.ROOT, "%.1f° off", Math.abs(error))
                    : String.format(Locale.ROOT, "%.1f° too %s", Math.abs(error), error < 0 ? "low" : "high");
            return highest - lowest > AT_REST_DEGREES ? place + " and still moving" : place;
        }
    }

    @Override
    public Scene scene(RandomSource random) {
        return Scene.of(RobotStart.at(-1, 0));
    }

    @Override
    public void see(WorldState state) {
        if (state.seconds() > JUDGED_FROM_SECONDS) {
            left.see(state.robot());
            right.see(state.robot());
        }
    }

    @Override
    public Score score() {
        String finding = "left arm " + left + ", right arm " + right + " (tolerance 2°)";
        return left.isRight() && right.isRight()
                ? Score.passed(finding)
                : Score.failed(
                        left.isRight() || right.isRight() ? 5 : 0,
                        finding,
                        "Set a separate speed for each shoulder, and 0 once the shoulder has reached its"
                                + " angle. A fast arm overshoots; at 10 °/s, the arm does not get there within 4 s.");
    }
}
