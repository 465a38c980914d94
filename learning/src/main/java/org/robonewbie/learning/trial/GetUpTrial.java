package org.robonewbie.learning.trial;

import java.util.List;
import org.robonewbie.agent.walk.Stance;
import org.robonewbie.nao.Vector3;
import org.robonewbie.nao.motion.Motion;

/**
 * A lying robot that has to get up: success is to stand in the stance one second after the end of the motions, upright and at
 * rest.
 *
 * @param success whether it stands
 * @param seconds time of the motions
 * @param bestPromise the best {@link #promise} on the way, from the first third on
 * @param lastPromise the promise at the end
 * @param rocking mean speed of the torso about the horizontal axes, degrees per second
 * @param jointsAtLimit mean number of joints at their speed limit
 */
public record GetUpTrial(
        boolean success, double seconds, double bestPromise, double lastPromise, double rocking, double jointsAtLimit) {

    private static final double UPRIGHT = 0.97;
    private static final double STANDING_TORSO = 0.32;
    private static final double POSTURE_DEGREES = 3;
    private static final double REST = 0.05;
    private static final double HOPELESS_TORSO = 0.13;

    /**
     * Carries out a trial.
     *
     * @param robot a robot that lies
     * @param motions what it plays, in this order
     * @param observer sees each cycle
     * @return what happened
     */
    public static GetUpTrial run(TrialRobot robot, List<Motion> motions, TrialObserver observer) {
        Recorder recorder = new Recorder(
                robot, motions.stream().mapToInt(Motion::durationMillis).sum() / 1000.0);
        TrialObserver all = observer.and(recorder);
        boolean done = true;
        for (Motion motion : motions) {
            done = done && robot.play(motion, all);
        }
        double seconds = recorder.seconds(robot);
        Watch watch = new Watch();
        done = done && robot.hold(1, observer.and(watch));
        boolean success = done && stands(robot);
        return new GetUpTrial(
                success,
                seconds,
                recorder.best,
                promise(robot),
                recorder.turning / Math.max(1, recorder.cycles),
                recorder.atLimit / Math.max(1, recorder.cycles));
    }

    /**
     * Judges how near a robot is to standing: soles flat on the ground, centre of mass above them, torso upright and high.
     *
     * @param robot the robot
     * @return about -1 lying, 3.6 standing
     */
    public static double promise(TrialRobot robot) {
        Vector3 left = robot.link("lfoot").position();
        Vector3 right = robot.link("rfoot").position();
        Vector3 middle = left.plus(right).times(0.5);
        Vector3 mass = robot.centreOfMass();
        double flat = (robot.link("lfoot").rotation().zz()
                        + robot.link("rfoot").rotation().zz())
                / 2;
        double beside = Math.hypot(mass.x() - middle.x(), mass.y() - middle.y());
        return 0.6 * flat
                + robot.uprightness()
                + 2 * Math.min(1, robot.torso().z() / 0.34)
                - 4 * Math.min(0.3, Math.max(0, beside - 0.02))
                - 4 * Math.min(0.2, Math.max(0, middle.z() - 0.01));
    }

    private static boolean stands(TrialRobot robot) {
        return robot.uprightness() > UPRIGHT
                && robot.torso().z() > STANDING_TORSO
                && robot.velocity().length() < REST
                && robot.posture().largestDifference(Stance.POSTURE) < POSTURE_DEGREES;
    }

    /** Sees how the robot gets on, and gives up when it still lies shortly before the end. */
    private static final class Recorder implements TrialObserver {

        private final double start;
        private final double duration;
        private double best = -2;
        private double turning;
        private double atLimit;
        private int cycles;

        Recorder(TrialRobot robot, double duration) {
            this.start = robot.seconds();
            this.duration = duration;
        }

        double seconds(TrialRobot robot) {
            return robot.seconds() - start;
        }

        @Override
        public boolean goOn(TrialRobot robot) {
            Watch once = new Watch();
            once.goOn(robot);
            turning += once.meanRocking();
            atLimit += once.meanJointsAtLimit();
            cycles++;
            if (seconds(robot) > duration / 3) {
                best = Math.max(best, promise(robot));
            }
            return seconds(robot) < duration - 0.6 || robot.torso().z() > HOPELESS_TORSO;
        }
    }
}
