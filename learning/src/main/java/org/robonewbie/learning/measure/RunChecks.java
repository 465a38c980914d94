package org.robonewbie.learning.measure;

import java.util.List;
import org.robonewbie.agent.policy.file.PolicyFile;
import org.robonewbie.agent.walk.PolicyWalk;
import org.robonewbie.agent.walk.WalkVelocity;
import org.robonewbie.learning.rehearsal.Rehearsal;
import org.robonewbie.nao.model.RobotType;

/** Checks of the run that was learned: an agent on a whole simulator with noise, which keeps to its line by its own sensors. */
final class RunChecks {

    private static final double LONG_WAY = 20;
    private static final double SECONDS_TO_SLOW_DOWN = 3;
    private static final double MOST_DRIFT = 10;

    /** What is commanded, metres per second: less than the run can do, so that it is steady for long. */
    private static final double COMMANDED = 1.35;

    private final RobotType type;
    private final PolicyWalk learned = new PolicyWalk(PolicyFile.shipped("run"));

    private RunChecks(RobotType type) {
        this.type = type;
    }

    static List<MotionCheck> all(RobotType type) {
        RunChecks checks = new RunChecks(type);
        return List.of(checks.far(), checks.drift(), checks.stop());
    }

    private CheckStart start() {
        return CheckStart.onLeaguePitch(type, learned);
    }

    private MotionCheck far() {
        String rule = "runs 20 m without a fall";
        return start().check("learned run 20 m", rule, "m/s over the way", (robot, seed) -> {
            boolean up = runFar(robot);
            return new Outcome(up, robot.forward() / robot.seconds());
        });
    }

    private MotionCheck drift() {
        String rule = "the way's direction is at most 10° beside the first heading";
        return start().check("learned run 20 m, drift", rule, "degrees to either side", (robot, seed) -> {
            boolean up = runFar(robot);
            double degrees = Math.abs(Math.toDegrees(Math.atan2(robot.left(), robot.forward())));
            return new Outcome(up && degrees <= MOST_DRIFT, degrees);
        });
    }

    private MotionCheck stop() {
        String rule = "runs 20 m, slows down within 3 s, stops, ends in the stance";
        return start().check("learned run 20 m, stop", rule, "s from the 20 m to the stance", (robot, seed) -> {
            runFar(robot);
            double begin = robot.seconds();
            robot.walk(
                    () -> ahead(1 - (robot.seconds() - begin) / SECONDS_TO_SLOW_DOWN),
                    () -> robot.seconds() < begin + SECONDS_TO_SLOW_DOWN);
            boolean stands = robot.stopWalking();
            double seconds = robot.seconds() - begin;
            return new Outcome(stands && robot.endsInStance(), seconds);
        });
    }

    private boolean runFar(Rehearsal robot) {
        return robot.walk(() -> ahead(1), () -> robot.forward() < LONG_WAY);
    }

    private WalkVelocity ahead(double share) {
        return new WalkVelocity(COMMANDED * Math.max(0, share), 0, 0);
    }
}
