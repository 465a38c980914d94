package org.robonewbie.nao.kinematics;

import org.robonewbie.nao.model.NaoModel;
import org.robonewbie.nao.model.RobotType;
import org.robonewbie.nao.motion.Posture;

/**
 * Inverse kinematics of the legs: the angles of six joints that bring a foot to a target pose relative to the torso.
 *
 * <pre>{@code
 * InverseKinematics kinematics = new InverseKinematics(RobotType.TYPE_0);
 * Pose target = new Pose(new Vector3(0.02, 0.055, -0.33), Rotation.NONE);
 * LegSolution solution = kinematics.solve(Leg.LEFT, target);
 * Posture posture = solution.applyTo(standing);
 * }</pre>
 *
 * <p>Method: damped least squares (Levenberg 1944, Marquardt 1963) with joint limits. A joint at its stop is excluded while the
 * gradient pushes it further. Solving for a reachable pose takes a few microseconds; for an unreachable one, it takes
 * up to a millisecond, because the search is repeated from several initial postures. Instances are not thread-safe.
 */
public final class InverseKinematics {

    private static final double[] BENT_KNEES = {0, 0, 30, -60, 30, 0};

    /** Initial leg postures spread over the joints' ranges, tried in turn if the search from the given posture fails. */
    private static final double[][] OTHER_STARTS = {
        {-30, 0, 60, -100, 40, 0},
        {0, 0, -10, -20, 10, 0},
        {-70, 20, 20, -90, 40, 0},
        {-70, -20, 20, -90, 40, 0},
        {-20, 20, 20, -90, 0, 20},
        {-20, -20, 20, -90, 0, -20},
        {-70, 20, 80, -30, -20, 0},
        {-70, -20, 80, -30, -20, 0},
        {-20, 20, 0, -30, 60, -20},
        {-20, -20, 0, -30, 60, 20},
        {-45, 0, 90, -120, -30, 0},
        {-80, 0, -10, -120, 70, 0}
    };

    private final LegSolver[] solvers = new LegSolver[Leg.values().length];

    /**
     * Creates the inverse kinematics of a robot type.
     *
     * @param type the robot type
     */
    public InverseKinematics(RobotType type) {
        for (Leg leg : Leg.values()) {
            solvers[leg.ordinal()] = new LegSolver(NaoModel.of(type), leg);
        }
    }

    /**
     * Finds the angles, starting the search with bent knees.
     *
     * @param leg the leg
     * @param foot target pose of the foot's box relative to the torso; the sole is 1 cm below the box's centre
     * @return the angles; if the pose is unreachable, those that bring the foot closest to it
     */
    public LegSolution solve(Leg leg, Pose foot) {
        return search(leg, CoordinateFrame.of(foot), BENT_KNEES);
    }

    /**
     * Finds the angles, starting the search from a nearby posture, such as that of the previous cycle.
     *
     * @param leg the leg
     * @param foot target pose of the foot's box relative to the torso; the sole is 1 cm below the box's centre
     * @param near initial posture of the search
     * @return the angles; if the pose is unreachable, those that bring the foot closest to it
     */
    public LegSolution solve(Leg leg, Pose foot, Posture near) {
        return solve(leg, CoordinateFrame.of(foot), near);
    }

    /**
     * Finds the angles for a target frame of the foot, starting the search from a nearby posture.
     *
     * @param leg the leg
     * @param foot target frame of the foot's box relative to the torso; the sole is 1 cm below the frame's origin
     * @param near initial posture of the search
     * @return the angles; if the frame is unreachable, those that bring the foot closest to it
     */
    public LegSolution solve(Leg leg, CoordinateFrame foot, Posture near) {
        double[] start = new double[LegChain.JOINTS];
        for (int i = 0; i < start.length; i++) {
            start[i] = near.degrees(leg.joints().get(i));
        }
        return search(leg, foot, start);
    }

    private LegSolution search(Leg leg, CoordinateFrame foot, double[] start) {
        LegSolver solver = solvers[leg.ordinal()];
        solver.setTarget(foot);
        solver.solve(start);
        for (int i = 0; i < OTHER_STARTS.length && !solver.isReached(); i++) {
            solver.solve(OTHER_STARTS[i]);
        }
        return solver.best();
    }
}
