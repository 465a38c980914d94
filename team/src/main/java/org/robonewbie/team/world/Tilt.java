package org.robonewbie.team.world;

import org.robonewbie.agent.Robot;
import org.robonewbie.nao.Cycle;
import org.robonewbie.nao.Vector3;
import org.robonewbie.nao.math.PortableMath;

/**
 * Feels how far the torso leans. The gyroscope says how it turns, which is exact but drifts; the accelerometer says where up is, which
 * does not drift but jumps with each step. A complementary filter takes the turns from the one and, very slowly, up from the
 * other.
 *
 * <p>What for: a robot that falls sees the pitch tilted. If it took these pictures for true, it would believe to be somewhere else.
 */
public final class Tilt {

    private static final double SHARE_OF_ACCELEROMETER = 0.02;
    private static final double MOST_DEGREES = 15;

    private Vector3 up = new Vector3(0, 0, 1);

    /** Creates the feeling of a robot that stands upright. */
    public Tilt() {}

    /**
     * Takes in one cycle.
     *
     * @param nao the robot
     */
    public void feel(Robot nao) {
        Vector3 turn = nao.getGyro().times(PortableMath.toRadians(Cycle.SECONDS));
        Vector3 turned = up.plus(up.cross(turn));
        Vector3 felt = nao.getAcceleration();
        double size = felt.length();
        Vector3 mixed = size < 1 || !Double.isFinite(size)
                ? turned
                : turned.times(1 - SHARE_OF_ACCELEROMETER).plus(felt.times(SHARE_OF_ACCELEROMETER / size));
        up = mixed.times(1 / mixed.length());
    }

    /** {@return how far the torso leans, degrees} */
    public double degrees() {
        return PortableMath.toDegrees(PortableMath.acos(Math.max(-1, Math.min(1, up.z()))));
    }

    /** {@return whether the robot stands so upright that what it sees is where it seems to be} */
    public boolean isUpright() {
        return degrees() < MOST_DEGREES;
    }
}
