package org.robonewbie.nao.kinematics;

import java.util.List;
import org.robonewbie.nao.Joint;
import org.robonewbie.nao.model.NaoModel;
import org.robonewbie.nao.model.RobotType;
import org.robonewbie.nao.motion.MutablePosture;
import org.robonewbie.nao.motion.Posture;

/**
 * Finds the angles of a leg's six joints that bring its foot to a wanted pose as seen from the torso.
 *
 * <pre>{@code
 * InverseKinematics kinematics = new InverseKinematics(RobotType.TYPE_0);
 * Pose wanted = new Pose(new Vector3(0.02, 0.055, -0.33), Rotation.NONE);
 * LegSolution solution = kinematics.solve(Leg.LEFT, wanted);
 * Posture posture = solution.applyTo(standing);
 * }</pre>
 *
 * <p>Method: damped least squares (Levenberg 1944, Marquardt 1963) within the joints' ranges; a joint at its stop is left out
 * as long as it wants to go further. A reachable pose takes some microseconds, one out of reach up to a millisecond, since
 * the search then begins at several places. One object serves one thread at a time.
 */
public final class InverseKinematics {

    private static final double[] BENT_KNEES = {0, 0, 30, -60, 30, 0};

    /** Legs all over their ranges, tried one after the other if the search from the given start fails. */
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
    private final MutablePose target = new MutablePose();
    private final double[] start = new double[LegChain.JOINTS];

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
     * Finds the angles, beginning the search with bent knees.
     *
     * @param leg which leg
     * @param foot wanted centre and turn of the foot's box as seen from the torso; the sole is 1 cm below the centre
     * @return the angles; if the pose cannot be reached, those that come nearest
     */
    public LegSolution solve(Leg leg, Pose foot) {
        return search(leg, foot, BENT_KNEES);
    }

    /**
     * Finds the angles, beginning the search with a posture that is near, such as the one before.
     *
     * @param leg which leg
     * @param foot wanted centre and turn of the foot's box as seen from the torso; the sole is 1 cm below the centre
     * @param near where the search begins
     * @return the angles; if the pose cannot be reached, those that come nearest
     */
    public LegSolution solve(Leg leg, Pose foot, Posture near) {
        List<Joint> joints = leg.joints();
        for (int i = 0; i < start.length; i++) {
            start[i] = near.degrees(joints.get(i));
        }
        return search(leg, foot, start);
    }

    /**
     * Puts a foot to a wanted place, or as near as it comes; makes no garbage.
     *
     * @param leg which leg
     * @param foot wanted centre and turn of the foot's box as seen from the torso; the sole is 1 cm below the centre
     * @param posture where the search begins; takes the angles of this leg
     */
    public void place(Leg leg, MutablePose foot, MutablePosture posture) {
        List<Joint> joints = leg.joints();
        for (int i = 0; i < start.length; i++) {
            start[i] = posture.degrees(joints.get(i));
        }
        LegSolver solver = solvers[leg.ordinal()];
        solver.setTarget(foot);
        solveFrom(solver, start);
        for (int i = 0; i < start.length; i++) {
            posture.set(joints.get(i), solver.bestDegrees(i));
        }
    }

    private LegSolution search(Leg leg, Pose foot, double[] begin) {
        LegSolver solver = solvers[leg.ordinal()];
        target.set(foot);
        solver.setTarget(target);
        solveFrom(solver, begin);
        return solver.best();
    }

    private static void solveFrom(LegSolver solver, double[] begin) {
        solver.solve(begin);
        for (int i = 0; i < OTHER_STARTS.length && !solver.isReached(); i++) {
            solver.solve(OTHER_STARTS[i]);
        }
    }
}
