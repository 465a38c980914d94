package org.robonewbie.learning.rehearsal;

import org.robonewbie.nao.Cycle;
import org.robonewbie.nao.Joint;
import org.robonewbie.nao.Vector3;
import org.robonewbie.nao.kinematics.BodyState;
import org.robonewbie.nao.math.PortableMath;
import org.robonewbie.trial.WorldState;
import org.robonewbie.trial.measure.MeasureFromStart;

/** How steadily a robot keeps on its feet and how smoothly it moves: how fast its torso rocks in the mean. */
public final class Poise extends MeasureFromStart {

    private static final Vector3 UP = new Vector3(0, 0, 1);

    /** A joint that turns with this part of its largest speed is at its limit. */
    private static final double LIMIT = 0.99;

    private int cycles;
    private double sines;
    private double degreesPerSecond;
    private double jointsAtLimit;
    private BodyState before;

    Poise(BodyState body) {
        before = body;
    }

    @Override
    protected void see(WorldState first, WorldState now) {
        BodyState body = now.robot();
        Vector3 up = up(body);
        cycles++;
        sines += PortableMath.hypot(up.x(), up.y());
        degreesPerSecond += PortableMath.toDegrees(up.distanceTo(up(before))) / Cycle.SECONDS;
        for (Joint joint : Joint.values()) {
            double turned = Math.abs(body.degrees(joint) - before.degrees(joint));
            jointsAtLimit += turned >= LIMIT * joint.maxDegreesPerSecond() * Cycle.SECONDS ? 1 : 0;
        }
        before = body;
    }

    private static Vector3 up(BodyState body) {
        return body.torso().rotation().apply(UP);
    }

    @Override
    public double value() {
        return meanRocking();
    }

    @Override
    public String unit() {
        return "°/s";
    }

    @Override
    public boolean isLargerBetter() {
        return false;
    }

    /** {@return the mean sine of the torso's tilt} */
    public double meanTilt() {
        return sines / Math.max(1, cycles);
    }

    /** {@return the mean speed with which the torso turns about horizontal axes, degrees per second} */
    public double meanRocking() {
        return degreesPerSecond / Math.max(1, cycles);
    }

    /** {@return the mean number of joints at their speed limit} */
    public double meanJointsAtLimit() {
        return jointsAtLimit / Math.max(1, cycles);
    }
}
