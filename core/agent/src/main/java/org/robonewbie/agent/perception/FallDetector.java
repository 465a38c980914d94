package org.robonewbie.agent.perception;

import org.robonewbie.nao.Cycle;
import org.robonewbie.nao.kinematics.BodyState;
import org.robonewbie.nao.math.PortableMath;

/**
 * Detects falls with the accelerometer, whose reading at rest is 9.81 m/s², directed away from the ground. Foot impacts
 * during walking cause much higher but brief readings, which are clipped and smoothed.
 */
public final class FallDetector {

    private static final double SMOOTHING_SECONDS = 0.2;
    private static final double MAX_ACCELERATION = 20;
    private static final double COSINE_OF_FALL = PortableMath.cos(PortableMath.toRadians(BodyState.FALLEN_DEGREES));
    private static final double GRAVITY = 9.81;

    /** Smoothed acceleration along the torso's forward, left and up axes, m/s². */
    private double forward;

    private double left;
    private double up = GRAVITY;

    /** Creates a detector for an upright robot. */
    public FallDetector() {}

    /**
     * Adds a reading.
     *
     * @param torso the accelerometer's reading; non-finite values are ignored
     */
    public void update(TorsoMotion torso) {
        double strength = torso.acceleration().length();
        if (!Double.isFinite(strength)) {
            return;
        }
        double bound = strength > MAX_ACCELERATION ? MAX_ACCELERATION / strength : 1;
        double share = Cycle.SECONDS / SMOOTHING_SECONDS;
        forward += share * (bound * torso.acceleration().x() - forward);
        left += share * (bound * torso.acceleration().y() - left);
        up += share * (bound * torso.acceleration().z() - up);
    }

    /** Resets the detector to upright after the robot has been placed elsewhere. */
    public void reset() {
        forward = 0;
        left = 0;
        up = GRAVITY;
    }

    /** {@return the angle between the torso and the vertical, 0 to 180 degrees} */
    public double tiltDegrees() {
        double length = length();
        return length == 0 ? 0 : PortableMath.toDegrees(PortableMath.acos(Math.max(-1, Math.min(1, up / length))));
    }

    /** {@return the orientation of the torso: upright, or the side on which the robot is lying} */
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
