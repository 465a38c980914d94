package org.robonewbie.learning.rehearsal;

import org.robonewbie.agent.walk.Stance;
import org.robonewbie.nao.Vector3;
import org.robonewbie.nao.kinematics.BodyPoses;
import org.robonewbie.nao.kinematics.BodyState;
import org.robonewbie.nao.kinematics.Leg;
import org.robonewbie.nao.kinematics.Pose;
import org.robonewbie.nao.model.RobotType;
import org.robonewbie.nao.motion.Motion;
import org.robonewbie.trial.WorldState;
import org.robonewbie.trial.measure.MeasureFromStart;

/**
 * A lying robot that has to get up: success is to stand in the stance one second after the end of the motion, upright and at
 * rest.
 *
 * @param success whether it stands
 * @param seconds time of the motion
 * @param bestPromise how near it came to standing on the way, from the first third on: about -1 lying, 3.6 standing
 * @param lastPromise the promise at the end
 * @param degreesBeside the largest difference of a joint from the stance at last
 * @param rocking mean speed of the torso about the horizontal axes, degrees per second
 * @param jointsAtLimit mean number of joints at their speed limit
 */
public record GetUpTrial(
        boolean success,
        double seconds,
        double bestPromise,
        double lastPromise,
        double degreesBeside,
        double rocking,
        double jointsAtLimit) {

    private static final double SETTLING_SECONDS = 1;
    private static final double HOPELESS_TORSO = 0.13;
    private static final Vector3 UP = new Vector3(0, 0, 1);

    /**
     * Carries out a trial.
     *
     * @param lying how the robot lies at first
     * @param motion how it gets up
     * @param seed chooses its fall
     * @return what happened
     */
    public static GetUpTrial run(Lying lying, Motion motion, long seed) {
        return run(lying, RobotType.TYPE_0, motion, seed);
    }

    /**
     * Carries out a trial with a robot of some build.
     *
     * @param lying how the robot lies at first
     * @param type how it is built
     * @param motion how it gets up
     * @param seed chooses its fall
     * @return what happened
     */
    public static GetUpTrial run(Lying lying, RobotType type, Motion motion, long seed) {
        try (Rehearsal robot = lying.fallen(type, seed)) {
            return run(robot, motion, SETTLING_SECONDS);
        }
    }

    /** Carries out a trial with a robot that lies on the ground. */
    static GetUpTrial run(Rehearsal robot, Motion motion, double settlingSeconds) {
        Progress progress = new Progress(motion.durationMillis() / 3000.0);
        robot.watch(progress);
        robot.play(motion);
        double seconds = robot.seconds();
        double best = progress.value();
        double rocking = robot.poise().meanRocking();
        double jointsAtLimit = robot.poise().meanJointsAtLimit();
        boolean hopeful = robot.body().position().z() > HOPELESS_TORSO;
        boolean success = hopeful && robot.hold(settlingSeconds) && robot.isInStance();
        double beside = robot.body().joints().largestDifference(Stance.POSTURE);
        return new GetUpTrial(success, seconds, best, promise(robot.body()), beside, rocking, jointsAtLimit);
    }

    /** How near a robot is to standing: soles flat on the ground, centre of mass above them, torso upright and high. */
    private static double promise(BodyState body) {
        BodyPoses limbs = body.limbs();
        Vector3 middle = limbs.foot(Leg.LEFT)
                .position()
                .plus(limbs.foot(Leg.RIGHT).position())
                .times(0.5);
        Vector3 mass = limbs.centreOfMass();
        double flat = (upright(limbs.foot(Leg.LEFT)) + upright(limbs.foot(Leg.RIGHT))) / 2;
        double beside = Math.hypot(mass.x() - middle.x(), mass.y() - middle.y());
        return 0.6 * flat
                + upright(body.torso())
                + 2 * Math.min(1, body.position().z() / 0.34)
                - 4 * Math.min(0.3, Math.max(0, beside - 0.02))
                - 4 * Math.min(0.2, Math.max(0, middle.z() - 0.01));
    }

    private static double upright(Pose pose) {
        return pose.rotation().apply(UP).z();
    }

    /** The best promise from some time on. */
    private static final class Progress extends MeasureFromStart {

        private final double fromSeconds;
        private double best = -2;

        Progress(double fromSeconds) {
            this.fromSeconds = fromSeconds;
        }

        @Override
        protected void see(WorldState first, WorldState now) {
            if (now.seconds() - first.seconds() > fromSeconds) {
                best = Math.max(best, promise(now.robot()));
            }
        }

        @Override
        public double value() {
            return best;
        }
    }
}
