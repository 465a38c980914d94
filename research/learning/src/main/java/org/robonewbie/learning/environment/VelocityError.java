package org.robonewbie.learning.environment;

import org.robonewbie.agent.walk.WalkVelocity;
import org.robonewbie.nao.geometry.Angles;
import org.robonewbie.nao.geometry.Pose2d;
import org.robonewbie.nao.math.PortableMath;

/**
 * Accumulated difference between the commanded and the true velocity.
 *
 * @param windows the number of time windows
 * @param metresPerSecond the sum of the errors of the linear velocity over all windows
 * @param degreesPerSecond the sum of the errors of the turning speed over all windows
 */
public record VelocityError(int windows, double metresPerSecond, double degreesPerSecond) {

    /** The error over zero windows. */
    public static final VelocityError NONE = new VelocityError(0, 0, 0);

    private static final double MAX_COST = 1.5;

    /**
     * Returns the difference between a command and the motion from one pose to another, in the frame of their mean
     * heading.
     */
    static VelocityError between(Pose2d before, Pose2d now, double seconds, WalkVelocity command) {
        double turned = Angles.wrap(now.degrees() - before.degrees());
        Pose2d middle = new Pose2d(before.x(), before.y(), before.degrees() + turned / 2);
        double error = PortableMath.hypot(
                middle.ahead(now.point(0, 0, 0)) / seconds - command.forward(),
                middle.left(now.point(0, 0, 0)) / seconds - command.left());
        return new VelocityError(1, error, Math.abs(turned / seconds - command.turn()));
    }

    /**
     * Returns the cost of one window: an error equal to one of the tolerances counts as 1, and the sum is limited to 1.5.
     */
    double cost(double toleratedMetresPerSecond, double toleratedDegreesPerSecond) {
        return Math.min(
                MAX_COST, metresPerSecond / toleratedMetresPerSecond + degreesPerSecond / toleratedDegreesPerSecond);
    }

    /**
     * Adds another error.
     *
     * @param other the other error
     * @return the sum
     */
    public VelocityError plus(VelocityError other) {
        return new VelocityError(
                windows + other.windows,
                metresPerSecond + other.metresPerSecond,
                degreesPerSecond + other.degreesPerSecond);
    }
}
