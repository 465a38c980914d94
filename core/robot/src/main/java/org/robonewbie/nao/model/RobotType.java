package org.robonewbie.nao.model;

import org.robonewbie.nao.Vector3;

/**
 * The five variants of the NAO in SimSpark ({@code naorobottypes.rb}). Masses and link sizes are the same for all of
 * them.
 *
 * <p>Lengths are in metres, speeds in radians per second.
 */
public enum RobotType {
    /** The standard robot. */
    TYPE_0(0.055, -0.04, -0.055, 6.1395, 6.1395, 0.07, 0),
    /** Longer legs and arms than type 0. */
    TYPE_1(0.055, -0.05832, -0.07332, 6.1395, 6.1395, 0.10664, 0),
    /** Faster ankle pitch and slower ankle roll than type 0. */
    TYPE_2(0.055, -0.04, -0.055, 8.80667, 3.47234, 0.07, 0),
    /** The longest legs and arms, and wider hips than type 0. */
    TYPE_3(0.072954143, -0.067868424, -0.082868424, 6.1395, 6.1395, 0.125736848, 0),
    /** Like type 0, but with hinged toes. */
    TYPE_4(0.055, -0.04, -0.055, 6.1395, 6.1395, 0.07, 0.035517656);

    private final double hipX;
    private final double thighZ;
    private final double ankleZ;
    private final double anklePitchSpeed;
    private final double ankleRollSpeed;
    private final double elbowY;
    private final double toeLength;

    RobotType(
            double hipX,
            double thighZ,
            double ankleZ,
            double anklePitchSpeed,
            double ankleRollSpeed,
            double elbowY,
            double toeLength) {
        this.hipX = hipX;
        this.thighZ = thighZ;
        this.ankleZ = ankleZ;
        this.anklePitchSpeed = anklePitchSpeed;
        this.ankleRollSpeed = ankleRollSpeed;
        this.elbowY = elbowY;
        this.toeLength = toeLength;
    }

    /** {@return whether the feet have hinged toes; true for type 4 only} */
    public boolean hasToes() {
        return toeLength > 0;
    }

    /**
     * Returns the name of a motion's variant for this robot type. Types 1 and 3, which have longer legs, use the motion
     * with the suffix {@code -long-legs}.
     *
     * @param motion the name of the motion for the standard robot, such as {@code quick-stand-up-from-back}
     * @return the name of the variant
     */
    public String ownMotion(String motion) {
        return thighZ < TYPE_0.thighZ ? motion + "-long-legs" : motion;
    }

    double toeLength() {
        return toeLength;
    }

    double anklePitchSpeed() {
        return anklePitchSpeed;
    }

    double ankleRollSpeed() {
        return ankleRollSpeed;
    }

    Vector3 hipFromTorso() {
        return new Vector3(hipX, -0.01, -0.115);
    }

    Vector3 thighFromHip() {
        return new Vector3(0, 0.01, thighZ);
    }

    Vector3 ankleFromShank() {
        return new Vector3(0, -0.01, ankleZ);
    }

    Vector3 elbowFromUpperArm() {
        return new Vector3(-0.01, elbowY, 0.009);
    }
}
