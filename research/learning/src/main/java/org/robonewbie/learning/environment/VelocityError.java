package org.robonewbie.learning.environment;

import org.robonewbie.agent.walk.WalkVelocity;
import org.robonewbie.nao.geometry.Angles;
import org.robonewbie.nao.geometry.Pose2d;
import org.robonewbie.nao.math.PortableMath;

/**
 * Sum of the differences between commanded and true velocity over some windows of time.
 *
 * @param windows number of windows
 * @param metresPerSecond sum of the errors of the velocity
 * @param degreesPerSecond sum of the errors of the turning speed
 */
public record VelocityError(int windows, double metresPerSecond, double degreesPerSecond) {

    /** No window. */
    public static final VelocityError NONE = new VelocityError(0, 0, 0);

    private static final double MAX_COST = 1.5;

    /** Compares the way between two places, seen from half-way between their headings, with a command. */
    static VelocityError between(Pose2d before, Pose2d now, double seconds, WalkVelocity command) {
        double turned = Angles.wrap(now.degrees() - before.degrees());
        Pose2d middle = new Pose2d(before.x(), before.y(), before.degrees() + turned / 2);
        double error = PortableMath.hypot(
                middle.ahead(now.point(0, 0, 0)) / seconds - command.forward(),
                middle.left(now.point(0, 0, 0)) / seconds - command.left());
        return new VelocityError(1, error, Math.abs(turned / seconds - command.turn()));
    }

    /** Cost of one window: 1 for each tolerated error, 1.5 at most. */
    double cost(double toleratedMetresPerSecond, double toleratedDegreesPerSecond) {
        return Math.min(
                MAX_COST, metresPerSecond / toleratedMetresPerSecond + degreesPerSecond / toleratedDegreesPerSecond);
    }

    /**
     * Adds the errors of other windows.
     *
     * @param other the other windows
     * @return the sum
     */
    public VelocityError plus(VelocityError other) {
        return new VelocityError(
                windows + other.windows,
                metresPerSecond + other.metresPerSecond,
                degreesPerSecond + other.degreesPerSecond);
    }
}
