package org.robonewbie.nao.kinematics;

import org.robonewbie.nao.Vector3;
import org.robonewbie.nao.math.PortableMath;

/**
 * A frame of coordinates that is moved and turned along its own axes, one step after the other, as seen from where it began. It
 * keeps the three columns of its rotation matrix, so that such a chain of steps is quick and easy to follow.
 *
 * <pre>{@code
 * CoordinateFrame ground = CoordinateFrame.ORIGIN
 *         .moved(0, 0, -0.115)            // from the torso down to the hips
 *         .turnedAboutY(-leanDegrees)
 *         .moved(0, 0, -0.2);             // straight down, whatever the torso's lean
 * }</pre>
 *
 * @param origin where the frame is, in metres
 * @param forward its x axis
 * @param left its y axis
 * @param up its z axis
 */
public record CoordinateFrame(Vector3 origin, Vector3 forward, Vector3 left, Vector3 up) {

    private static final Vector3 X = new Vector3(1, 0, 0);
    private static final Vector3 Y = new Vector3(0, 1, 0);
    private static final Vector3 Z = new Vector3(0, 0, 1);

    /** Not moved and not turned. */
    public static final CoordinateFrame ORIGIN = new CoordinateFrame(Vector3.ZERO, X, Y, Z);

    /**
     * Creates the frame of something whose pose is known.
     *
     * @param pose position and rotation
     * @return the frame
     */
    public static CoordinateFrame of(Pose pose) {
        Rotation rotation = pose.rotation();
        return new CoordinateFrame(pose.position(), rotation.apply(X), rotation.apply(Y), rotation.apply(Z));
    }

    /**
     * Moves along the frame's own axes.
     *
     * @param x metres forward
     * @param y metres to the left
     * @param z metres up
     * @return the moved frame
     */
    public CoordinateFrame moved(double x, double y, double z) {
        Vector3 moved = new Vector3(
                origin.x() + (forward.x() * x + left.x() * y + up.x() * z),
                origin.y() + (forward.y() * x + left.y() * y + up.y() * z),
                origin.z() + (forward.z() * x + left.z() * y + up.z() * z));
        return new CoordinateFrame(moved, forward, left, up);
    }

    /**
     * Turns about the axis that points forward.
     *
     * @param degrees positive raises the left side
     * @return the turned frame
     */
    public CoordinateFrame turnedAboutX(double degrees) {
        double cosine = PortableMath.cos(PortableMath.toRadians(degrees));
        double sine = PortableMath.sin(PortableMath.toRadians(degrees));
        return new CoordinateFrame(origin, forward, sum(cosine, left, sine, up), sum(cosine, up, -sine, left));
    }

    /**
     * Turns about the axis that points to the left.
     *
     * @param degrees positive bends forward
     * @return the turned frame
     */
    public CoordinateFrame turnedAboutY(double degrees) {
        double cosine = PortableMath.cos(PortableMath.toRadians(degrees));
        double sine = PortableMath.sin(PortableMath.toRadians(degrees));
        return new CoordinateFrame(origin, sum(cosine, forward, -sine, up), left, sum(cosine, up, sine, forward));
    }

    /**
     * Turns about the axis that points up.
     *
     * @param degrees positive is to the left
     * @return the turned frame
     */
    public CoordinateFrame turnedAboutZ(double degrees) {
        double cosine = PortableMath.cos(PortableMath.toRadians(degrees));
        double sine = PortableMath.sin(PortableMath.toRadians(degrees));
        return new CoordinateFrame(origin, sum(cosine, forward, sine, left), sum(cosine, left, -sine, forward), up);
    }

    private static Vector3 sum(double a, Vector3 u, double b, Vector3 v) {
        return new Vector3(a * u.x() + b * v.x(), a * u.y() + b * v.y(), a * u.z() + b * v.z());
    }
}
