package org.robonewbie.workshop.motion;

import java.util.List;
import java.util.stream.Stream;
import org.robonewbie.agent.policy.file.PolicyFile;
import org.robonewbie.agent.walk.PolicyWalk;
import org.robonewbie.agent.walk.WalkVelocity;
import org.robonewbie.learning.motion.MotionTrial;
import org.robonewbie.nao.model.RobotType;

/** Checks of the learned runs: in a full simulator with noise, an agent uses its own sensors to keep to a line. */
final class RunChecks {

    private static final double LONG_WAY = 20;
    private static final double SPRINT = 15;

    private final RobotType type;
    private final Gait gait;
    private final PolicyWalk learned;

    private RunChecks(RobotType type, Gait gait) {
        this.type = type;
        this.gait = gait;
        this.learned = new PolicyWalk(PolicyFile.shipped(gait.policy));
    }

    static List<MotionCheck> all(RobotType type) {
        Stream<MotionCheck> gaits = Stream.of(Gait.RUN, Gait.JOG)
                .map(gait -> new RunChecks(type, gait))
                .flatMap(checks -> Stream.of(checks.far(), checks.drift(), checks.stop()));
        return Stream.concat(gaits, Stream.of(sprint(type))).toList();
    }

    private static MotionCheck sprint(RobotType type) {
        String rule = "sprints 15 m without a fall";
        return CheckStart.sprinter(type).check("learned sprint 15 m", rule, "m/s from the stance", (robot, seed) -> {
            boolean up = robot.walk(() -> new WalkVelocity(1, 0, 0), () -> robot.forward() < SPRINT);
            return new Outcome(up, robot.forward() / robot.seconds());
        });
    }

    private CheckStart start() {
        return CheckStart.onLeaguePitch(type, learned, gait.keeping);
    }

    private MotionCheck far() {
        String rule = gait.verb + " 20 m without a fall";
        return start().check("learned " + gait.policy + " 20 m", rule, "m/s on average", (robot, seed) -> {
            boolean up = runFar(robot);
            return new Outcome(up, robot.forward() / robot.seconds());
        });
    }

    private MotionCheck drift() {
        String rule = "the walked direction is within " + gait.mostDrift + "° of the initial heading";
        String name = "learned " + gait.policy + " 20 m, drift";
        return start().check(name, rule, "degrees to either side", (robot, seed) -> {
            boolean up = runFar(robot);
            double degrees = Math.abs(Math.toDegrees(Math.atan2(robot.left(), robot.forward())));
            return new Outcome(up && degrees <= gait.mostDrift, degrees);
        });
    }

    private MotionCheck stop() {
        String rule = gait.verb + " 20 m, " + gait.stopping + "stops, ends in the stance";
        String name = "learned " + gait.policy + " 20 m, stop";
        return start().check(name, rule, "s from the 20 m to the stance", (robot, seed) -> {
            runFar(robot);
            double begin = robot.seconds();
            robot.walk(
                    () -> ahead(1 - (robot.seconds() - begin) / gait.secondsToSlowDown),
                    () -> robot.seconds() < begin + gait.secondsToSlowDown);
            boolean stands = robot.stopWalking();
            double seconds = robot.seconds() - begin;
            return new Outcome(stands && robot.endsInStance(), seconds);
        });
    }

    private boolean runFar(MotionTrial robot) {
        return robot.walk(() -> ahead(1), () -> robot.forward() < LONG_WAY);
    }

    private WalkVelocity ahead(double share) {
        return new WalkVelocity(gait.commanded * Math.max(0, share), 0, 0);
    }

    /** Learned gait and its requirements. */
    private record Gait(
            String policy,
            String verb,
            double commanded,
            LineKeeping keeping,
            int mostDrift,
            String stopping,
            double secondsToSlowDown) {

        /** The run, below its maximum speed, so that the robot stays stable over long distances. */
        static final Gait RUN = new Gait("run", "runs", 1.35, LineKeeping.GENTLE, 10, "slows down within 3 s, ", 3);

        static final Gait JOG = new Gait("jog", "jogs", 1.05, LineKeeping.FIRM, 2, "", 0);
    }
}
