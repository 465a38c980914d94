package org.robonewbie.nao.kinematics;

import org.robonewbie.nao.Joint;
import org.robonewbie.nao.motion.Posture;

/** The angles of one leg that bring its foot to a wanted pose, or as near as the joints' ranges allow. Unmodifiable. */
public final class LegSolution {

    private static final double REACHED_METRES = 1e-4;
    private static final double REACHED_DEGREES = 0.05;

    private final Leg leg;
    private final double[] degrees;
    private final double positionErrorMetres;
    private final double rotationErrorDegrees;

    LegSolution(Leg leg, double[] degrees, double positionErrorMetres, double rotationErrorDegrees) {
        this.leg = leg;
        this.degrees = degrees.clone();
        this.positionErrorMetres = positionErrorMetres;
        this.rotationErrorDegrees = rotationErrorDegrees;
    }

    /**
     * Tells whether the foot gets there.
     *
     * @return true if the foot is less than 0.1 mm and 0.05° away from the wanted pose
     */
    public boolean isReachable() {
        return isReached(positionErrorMetres, rotationErrorDegrees);
    }

    /** Whether what is missing is so little. */
    static boolean isReached(double errorMetres, double errorDegrees) {
        return errorMetres < REACHED_METRES && errorDegrees < REACHED_DEGREES;
    }

    /**
     * Tells how far the foot stays away.
     *
     * @return the distance to the wanted position in metres
     */
    public double positionErrorMetres() {
        return positionErrorMetres;
    }

    /**
     * Tells how wrongly the foot is turned.
     *
     * @return the angle to the wanted rotation in degrees
     */
    public double rotationErrorDegrees() {
        return rotationErrorDegrees;
    }

    /**
     * Looks up an angle.
     *
     * @param joint a joint of this leg
     * @return its angle in degrees, within its range
     * @throws IllegalArgumentException if the joint belongs to another limb
     */
    public double degrees(Joint joint) {
        int index = leg.joints().indexOf(joint);
        if (index < 0) {
            throw new IllegalArgumentException(joint + " is no joint of the " + leg + " leg.");
        }
        return degrees[index];
    }

    /**
     * Puts this leg's angles into a posture.
     *
     * @param posture any posture
     * @return the posture with the six angles of this leg replaced
     */
    public Posture applyTo(Posture posture) {
        double[] all = posture.toArray();
        for (int i = 0; i < degrees.length; i++) {
            all[leg.joints().get(i).ordinal()] = degrees[i];
        }
        return Posture.of(all);
    }
}
