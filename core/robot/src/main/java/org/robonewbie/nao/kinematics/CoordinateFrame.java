package org.robonewbie.nao.kinematics;

import org.robonewbie.nao.Vector3;
import org.robonewbie.nao.math.PortableMath;

/**
 * A coordinate frame, given by its origin and axes in a reference frame. It is built from a chain of translations and
 * rotations, each along or about the axes of the previous frame. The three axes are the columns of the rotation matrix.
 *
 * <pre>{@code
 * CoordinateFrame ground = CoordinateFrame.ORIGIN
 *         .moved(0, 0, -0.115)            // from the torso down to the hips
 *         .turnedAboutY(-leanDegrees)
 *         .moved(0, 0, -0.2);             // straight down, whatever the torso's lean
 * }</pre>
 *
 * @param origin the frame's origin in metres
 * @param forward the frame's x axis
 * @param left the frame's y axis
 * @param up the frame's z axis
 */
public record CoordinateFrame(Vector3 origin, Vector3 forward, Vector3 left, Vector3 up) {

    private static final Vector3 X = new Vector3(1, 0, 0);
    private static final Vector3 Y = new Vector3(0, 1, 0);
    private static final Vector3 Z = new Vector3(0, 0, 1);

    /** The reference frame itself. */
    public static final CoordinateFrame ORIGIN = new CoordinateFrame(Vector3.ZERO, X, Y, Z);

    /**
     * Creates a frame with the given pose.
     *
     * @param pose position and rotation of the frame
     * @return the frame
     */
    public static CoordinateFrame of(Pose pose) {
        Rotation rotation = pose.rotation();
        return new CoordinateFrame(pose.position(), rotation.apply(X), rotation.apply(Y), rotation.apply(Z));
    }

    /**
     * Translates the frame along its own axes.
     *
     * @param x distance forward in metres
     * @param y distance to the left in metres
     * @param z distance up in metres
     * @return the translated frame
     */
    public CoordinateFrame moved(double x, double y, double z) {
        Vector3 moved = new Vector3(
                origin.x() + (forward.x() * x + left.x() * y + up.x() * z),
                origin.y() + (forward.y() * x + left.y() * y + up.y() * z),
                origin.z() + (forward.z() * x + left.z() * y + up.z() * z));
        return new CoordinateFrame(moved, forward, left, up);
    }

    /**
     * Rotates the frame about its forward axis.
     *
     * @param degrees angle in degrees; positive raises the left side
     * @return the rotated frame
     */
    public CoordinateFrame turnedAboutX(double degrees) {
        double cosine = PortableMath.cos(PortableMath.toRadians(degrees));
        double sine = PortableMath.sin(PortableMath.toRadians(degrees));
        return new CoordinateFrame(origin, forward, sum(cosine, left, sine, up), sum(cosine, up, -sine, left));
    }

    /**
     * Rotates the frame about its left axis.
     *
     * @param degrees angle in degrees; positive tilts the frame forward
     * @return the rotated frame
     */
    public CoordinateFrame turnedAboutY(double degrees) {
        double cosine = PortableMath.cos(PortableMath.toRadians(degrees));
        double sine = PortableMath.sin(PortableMath.toRadians(degrees));
        return new CoordinateFrame(origin, sum(cosine, forward, -sine, up), left, sum(cosine, up, sine, forward));
    }

    /**
     * Rotates the frame about its up axis.
     *
     * @param degrees angle in degrees; positive is to the left
     * @return the rotated frame
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
