package org.robonewbie.agent.perception;

import org.robonewbie.nao.Cycle;
import org.robonewbie.nao.kinematics.BodyState;
import org.robonewbie.nao.math.PortableMath;

/**
 * Feels with the accelerometer which way is up. At rest the accelerometer points away from the ground with 9.81 m/s²; the
 * knocks of walking feet are much stronger but short, so they are cut off and smoothed away.
 */
public final class FallDetector {

    private static final double SMOOTHING_SECONDS = 0.2;
    private static final double STRONGEST = 20;
    private static final double COSINE_OF_FALL = PortableMath.cos(PortableMath.toRadians(BodyState.FALLEN_DEGREES));
    private static final double GRAVITY = 9.81;

    /** The way up as the torso feels it, smoothed: its parts forward, to the left and along the torso. */
    private double forward;

    private double left;
    private double up = GRAVITY;

    /** Creates a detector that believes the robot to stand. */
    public FallDetector() {}

    /**
     * Takes in a reading.
     *
     * @param torso what the accelerometer feels; what is no number is ignored
     */
    public void update(TorsoMotion torso) {
        double strength = torso.acceleration().length();
        if (!Double.isFinite(strength)) {
            return;
        }
        double bound = strength > STRONGEST ? STRONGEST / strength : 1;
        double share = Cycle.SECONDS / SMOOTHING_SECONDS;
        forward += share * (bound * torso.acceleration().x() - forward);
        left += share * (bound * torso.acceleration().y() - left);
        up += share * (bound * torso.acceleration().z() - up);
    }

    /** Believes the robot to stand, after it was put somewhere else. */
    public void reset() {
        forward = 0;
        left = 0;
        up = GRAVITY;
    }

    /** {@return degrees between the torso and the direction away from the ground, 0 to 180} */
    public double tiltDegrees() {
        double length = length();
        return length == 0 ? 0 : PortableMath.toDegrees(PortableMath.acos(Math.max(-1, Math.min(1, up / length))));
    }

    /** {@return upright, or the side on which the robot lies} */
    public BodyPosition bodyPosition() {
        if (up >= COSINE_OF_FALL * length()) {
            return BodyPosition.UPRIGHT;
        }
        if (Math.abs(forward) >= Math.abs(left)) {
            return forward > 0 ? BodyPosition.LYING_ON_BACK : BodyPosition.LYING_ON_FRONT;
        }
        return left > 0 ? BodyPosition.LYING_ON_RIGHT_SIDE : BodyPosition.LYING_ON_LEFT_SIDE;
    }

    private double length() {
        return Math.sqrt(forward * forward + left * left + up * up);
    }
}
