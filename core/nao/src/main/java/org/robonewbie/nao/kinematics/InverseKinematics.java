package org.robonewbie.nao.kinematics;

import org.robonewbie.nao.model.NaoModel;
import org.robonewbie.nao.model.RobotType;
import org.robonewbie.nao.motion.Posture;

/**
 * Finds the angles of a leg's six joints that bring its foot to a wanted pose relative to the torso.
 *
 * <pre>{@code
 * InverseKinematics kinematics = new InverseKinematics(RobotType.TYPE_0);
 * Pose wanted = new Pose(new Vector3(0.02, 0.055, -0.33), Rotation.NONE);
 * LegSolution solution = kinematics.solve(Leg.LEFT, wanted);
 * Posture posture = solution.applyTo(standing);
 * }</pre>
 *
 * <p>Method: damped least squares (Levenberg 1944, Marquardt 1963) within the joints' ranges; a joint at its stop is left out
 * as long as it would have to move further. A reachable pose takes some microseconds, an unreachable one up to a millisecond,
 * since the search is then repeated from several starting points. Instances are not thread-safe.
 */
public final class InverseKinematics {

    private static final double[] BENT_KNEES = {0, 0, 30, -60, 30, 0};

    /** Leg postures spread over the joints' ranges, tried one after the other if the search from the given start fails. */
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
     * @param foot wanted centre and orientation of the foot's box relative to the torso; the sole is 1 cm below the centre
     * @return the angles; if the pose cannot be reached, those that come nearest
     */
    public LegSolution solve(Leg leg, Pose foot) {
        return search(leg, CoordinateFrame.of(foot), BENT_KNEES);
    }

    /**
     * Finds the angles, starting the search at a nearby posture, such as that of the previous cycle.
     *
     * @param leg the leg
     * @param foot wanted centre and orientation of the foot's box relative to the torso; the sole is 1 cm below the centre
     * @param near where the search starts
     * @return the angles; if the pose cannot be reached, those that come nearest
     */
    public LegSolution solve(Leg leg, Pose foot, Posture near) {
        return solve(leg, CoordinateFrame.of(foot), near);
    }

    /**
     * Finds the angles for a foot whose frame is known, beginning the search with a posture that is near.
     *
     * @param leg which leg
     * @param foot wanted frame of the foot's box as seen from the torso; the sole is 1 cm below its origin
     * @param near where the search begins
     * @return the angles; if the frame cannot be reached, those that come nearest
     */
    public LegSolution solve(Leg leg, CoordinateFrame foot, Posture near) {
        double[] begin = new double[LegChain.JOINTS];
        for (int i = 0; i < begin.length; i++) {
            begin[i] = near.degrees(leg.joints().get(i));
        }
        return search(leg, foot, begin);
    }

    private LegSolution search(Leg leg, CoordinateFrame foot, double[] begin) {
        LegSolver solver = solvers[leg.ordinal()];
        solver.setTarget(foot);
        solver.solve(begin);
        for (int i = 0; i < OTHER_STARTS.length && !solver.isReached(); i++) {
            solver.solve(OTHER_STARTS[i]);
        }
        return solver.best();
    }
}
