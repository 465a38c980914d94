package org.robonewbie.exercises;

import java.util.Locale;
import org.robonewbie.nao.Vector3;
import org.robonewbie.nao.geometry.Pose2d;
import org.robonewbie.nao.kinematics.BodyPoses;
import org.robonewbie.nao.kinematics.BodyState;
import org.robonewbie.nao.kinematics.Leg;
import org.robonewbie.nao.kinematics.Pose;
import org.robonewbie.simulator.world.BallProperties;

/** Determines how far the swinging foot is from the ball at the foremost point of the swing. */
final class FootBesideBall {

    private final Pose2d start;
    private final Vector3 ball;
    private double furthest = -Double.MAX_VALUE;
    private Vector3 nearest = Vector3.ZERO;

    /**
     * Creates an observer.
     *
     * @param start start pose of the robot, facing the ball
     * @param ball centre of the ball
     */
    FootBesideBall(Pose2d start, Vector3 ball) {
        this.start = start;
        this.ball = ball;
    }

    void see(BodyState robot) {
        BodyPoses limbs = robot.limbs();
        for (Leg leg : Leg.values()) {
            double forward = start.ahead(limbs.soleCorners(leg).get(0));
            if (forward > furthest) {
                furthest = forward;
                nearest = nearestPoint(limbs, leg);
            }
        }
    }

    /** Returns the point of the sole that is nearest to the ball. */
    private Vector3 nearestPoint(BodyPoses limbs, Leg leg) {
        Pose foot = limbs.foot(leg);
        Pose inFoot = foot.inverse();
        Vector3 corner = inFoot.transform(limbs.soleCorners(leg).get(0));
        Vector3 seen = inFoot.transform(ball);
        return foot.transform(new Vector3(
                within(seen.x(), corner.x()), within(seen.y(), corner.y()), within(seen.z(), Math.abs(corner.z()))));
    }

    private static double within(double value, double most) {
        return Math.max(-most, Math.min(most, value));
    }

    /** {@return a description of the miss, such as "the foot stayed 2.1 cm above it"} */
    String finding() {
        double gap = Math.max(0, nearest.distanceTo(ball) - BallProperties.STANDARD.radius());
        double behind = start.ahead(ball) - start.ahead(nearest);
        double aside = Math.abs(start.left(ball) - start.left(nearest));
        double above = nearest.z() - ball.z();
        String side = above > Math.max(Math.abs(behind), aside) ? "above" : aside > behind ? "beside" : "short of";
        return String.format(Locale.ROOT, "the foot stayed %.1f cm %s it", 100 * gap, side);
    }
}
