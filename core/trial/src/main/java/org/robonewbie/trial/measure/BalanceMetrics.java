package org.robonewbie.trial.measure;

import org.jspecify.annotations.Nullable;
import org.robonewbie.nao.Cycle;
import org.robonewbie.nao.Joint;
import org.robonewbie.nao.Vector3;
import org.robonewbie.nao.kinematics.BodyState;
import org.robonewbie.nao.math.PortableMath;
import org.robonewbie.trial.WorldState;

/**
 * Measures how steadily a robot moves: the mean angular speed of its torso about horizontal axes, and the mean number of joints
 * that move at their speed limit.
 */
public final class BalanceMetrics extends MeasureFromStart {

    private static final Vector3 UP = new Vector3(0, 0, 1);

    /** Fraction of a joint's maximum speed above which it counts as being at its limit. */
    private static final double LIMIT = 0.99;

    private @Nullable BodyState before;
    private int cycles;
    private double degreesPerSecond;
    private double jointsAtLimit;

    /** Creates the measure. */
    public BalanceMetrics() {
        super("°/s", false);
    }

    @Override
    protected void see(WorldState first, WorldState now) {
        BodyState last = before;
        before = now.robot();
        if (last != null) {
            compare(last, now.robot());
        }
    }

    private void compare(BodyState last, BodyState body) {
        cycles++;
        degreesPerSecond += PortableMath.toDegrees(up(body).distanceTo(up(last))) / Cycle.SECONDS;
        for (Joint joint : Joint.values()) {
            double turned = Math.abs(body.degrees(joint) - last.degrees(joint));
            jointsAtLimit += turned >= LIMIT * joint.maxDegreesPerSecond() * Cycle.SECONDS ? 1 : 0;
        }
    }

    private static Vector3 up(BodyState body) {
        return body.torso().rotation().apply(UP);
    }

    @Override
    public double value() {
        return degreesPerSecond / Math.max(1, cycles);
    }

    /** {@return the mean number of joints at their speed limit} */
    public double meanJointsAtLimit() {
        return jointsAtLimit / Math.max(1, cycles);
    }
}
