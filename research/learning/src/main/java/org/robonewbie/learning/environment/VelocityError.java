package org.robonewbie.learning.environment;

import org.robonewbie.agent.walk.WalkVelocity;
import org.robonewbie.nao.geometry.Angles;
import org.robonewbie.nao.geometry.Pose2d;
import org.robonewbie.nao.math.PortableMath;

/**
 * Accumulated difference between the commanded and the true velocity.
 *
 * @param windows the number of time windows
 * @param metresPerSecond the sum of the errors of the velocity
 * @param degreesPerSecond the sum of the errors of the turning speed
 */
public record VelocityError(int windows, double metresPerSecond, double degreesPerSecond) {

    /** The error of zero windows. */
    public static final VelocityError NONE = new VelocityError(0, 0, 0);

    private static final double MAX_COST = 1.5;

    /** Compares a command with the motion between two poses, taken in the frame of their mean heading. */
    static VelocityError between(Pose2d before, Pose2d now, double seconds, WalkVelocity command) {
        double turned = Angles.wrap(now.degrees() - before.degrees());
        Pose2d middle = new Pose2d(before.x(), before.y(), before.degrees() + turned / 2);
        double error = PortableMath.hypot(
                middle.ahead(now.point(0, 0, 0)) / seconds - command.forward(),
                middle.left(now.point(0, 0, 0)) / seconds - command.left());
        return new VelocityError(1, error, Math.abs(turned / seconds - command.turn()));
    }

    /** The cost of one window: each tolerance counts as 1, at most 1.5 in total. */
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
