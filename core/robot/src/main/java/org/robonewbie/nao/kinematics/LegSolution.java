package org.robonewbie.nao.kinematics;

import org.robonewbie.nao.Joint;
import org.robonewbie.nao.motion.Posture;

/**
 * The joint angles of one leg that bring its foot to a target pose, or as close to it as the joints' ranges allow.
 * Immutable.
 */
public final class LegSolution {

    private static final double REACHED_METRES = 1e-4;
    private static final double REACHED_DEGREES = 0.05;

    private final Leg leg;
    private final double[] degrees;
    private final double positionErrorMetres;
    private final double rotationErrorDegrees;

    LegSolution(Leg leg, double[] degrees, double positionErrorMetres, double rotationErrorDegrees) {
        this.leg = leg;
        this.degrees = degrees;
        this.positionErrorMetres = positionErrorMetres;
        this.rotationErrorDegrees = rotationErrorDegrees;
    }

    /** {@return whether the target pose is reached to within 0.1 mm and 0.05°} */
    public boolean isReachable() {
        return isReached(positionErrorMetres, rotationErrorDegrees);
    }

    static boolean isReached(double errorMetres, double errorDegrees) {
        return errorMetres < REACHED_METRES && errorDegrees < REACHED_DEGREES;
    }

    /** {@return the distance between the foot and the target position in metres} */
    public double positionErrorMetres() {
        return positionErrorMetres;
    }

    /** {@return the angle between the foot and the target orientation in degrees} */
    public double rotationErrorDegrees() {
        return rotationErrorDegrees;
    }

    /**
     * Returns the angle of a joint.
     *
     * @param joint a joint of this leg
     * @return its angle in degrees, within its range
     * @throws IllegalArgumentException if the joint belongs to another limb
     */
    public double degrees(Joint joint) {
        int index = leg.joints().indexOf(joint);
        if (index < 0) {
            throw new IllegalArgumentException(joint + " is not a joint of the " + leg + " leg.");
        }
        return degrees[index];
    }

    /**
     * Replaces this leg's angles in a posture.
     *
     * @param posture any posture
     * @return the posture with the six angles of this leg replaced
     */
    public Posture applyTo(Posture posture) {
        return posture.with(leg.joints(), degrees);
    }
}
