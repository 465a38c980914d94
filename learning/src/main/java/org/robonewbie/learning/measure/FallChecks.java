package org.robonewbie.learning.measure;

import java.util.List;
import org.robonewbie.learning.trial.Course;
import org.robonewbie.learning.trial.DiveTrial;
import org.robonewbie.learning.trial.Lying;
import org.robonewbie.learning.trial.TrialObserver;
import org.robonewbie.learning.trial.TrialRobot;
import org.robonewbie.nao.motion.file.ShippedMotions;

/** Checks of the motions that end on the ground or begin there. */
final class FallChecks {

    private static final double PUSH_NEWTONS = 3;

    private FallChecks() {}

    static List<MotionCheck> all() {
        return List.of(
                fall("fall-forward", Lying.ON_FRONT),
                fall("fall-back", Lying.ON_BACK),
                rollOver(),
                dive("dive-left", 1),
                dive("dive-right", -1));
    }

    private static MotionCheck fall(String name, Lying end) {
        return new MotionCheck(name, "stance", "ends " + end.words(), "s", seed -> {
            TrialRobot robot = new Course(seed, PUSH_NEWTONS).robot();
            double start = robot.seconds();
            robot.play(ShippedMotions.motion(name), TrialObserver.NONE);
            double seconds = robot.seconds() - start;
            robot.hold(1, TrialObserver.NONE);
            return new Outcome(end.isTrueOf(robot), seconds);
        });
    }

    private static MotionCheck rollOver() {
        String name = "roll-over-to-back";
        return new MotionCheck(name, "lying on front after a fall, arms anywhere", "ends lying on back", "s", seed -> {
            TrialRobot robot = Lying.ON_FRONT.fallen(seed);
            double start = robot.seconds();
            robot.play(ShippedMotions.motion(name), TrialObserver.NONE);
            double seconds = robot.seconds() - start;
            robot.hold(1, TrialObserver.NONE);
            return new Outcome(Lying.ON_BACK.isTrueOf(robot), seconds);
        });
    }

    private static MotionCheck dive(String name, int side) {
        return new MotionCheck(
                name,
                "stance, 0.1 s after a shot at 2 m/s from 2 m away, to pass up to 0.6 m aside",
                "the ball does not get past the robot",
                "m aside of the ball's way",
                seed -> {
                    DiveTrial trial = DiveTrial.run(ShippedMotions.motion(name), seed, side);
                    return new Outcome(trial.blocked(), Math.abs(trial.passesAt()));
                });
    }
}
