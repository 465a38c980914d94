package org.robonewbie.nao.kinematics;

import org.robonewbie.nao.Vector3;
import org.robonewbie.nao.geometry.Angles;
import org.robonewbie.nao.math.PortableMath;

/**
 * A rotation in space following the right-hand rule, stored as a unit quaternion.
 *
 * <pre>{@code
 * Vector3 left = Rotation.about(new Vector3(0, 0, 1), 90).apply(new Vector3(1, 0, 0));   // (0, 1, 0)
 * }</pre>
 *
 * @param w cosine of half the angle
 * @param x first component of the axis times the sine of half the angle
 * @param y second component
 * @param z third component
 */
public record Rotation(double w, double x, double y, double z) {

    /** The identity rotation. */
    public static final Rotation NONE = new Rotation(1, 0, 0, 0);

    /**
     * Creates a rotation about an axis.
     *
     * @param axis direction of the axis, of any length but 0
     * @param degrees angle in degrees; positive is counter-clockwise when the axis points at the viewer
     * @return the rotation
     */
    public static Rotation about(Vector3 axis, double degrees) {
        double half = PortableMath.toRadians(degrees) / 2;
        double factor = PortableMath.sin(half) / axis.length();
        return new Rotation(PortableMath.cos(half), factor * axis.x(), factor * axis.y(), factor * axis.z());
    }

    /**
     * Creates a rotation from intrinsic Tait-Bryan angles: first about z, then about the new y axis, then about the new x axis.
     *
     * @param yawDegrees rotation about z in degrees; positive is to the left
     * @param pitchDegrees rotation about y in degrees; positive is forward
     * @param rollDegrees rotation about x in degrees; positive is to the right
     * @return the rotation
     */
    public static Rotation ofYawPitchRoll(double yawDegrees, double pitchDegrees, double rollDegrees) {
        return about(new Vector3(0, 0, 1), yawDegrees)
                .times(about(new Vector3(0, 1, 0), pitchDegrees))
                .times(about(new Vector3(1, 0, 0), rollDegrees));
    }

    /**
     * Converts a rotation matrix, whose columns are the rotated axes. Elements are named by row and column.
     *
     * @param xx row x, column x
     * @param xy row x, column y
     * @param xz row x, column z
     * @param yx row y, column x
     * @param yy row y, column y
     * @param yz row y, column z
     * @param zx row z, column x
     * @param zy row z, column y
     * @param zz row z, column z
     * @return the unit quaternion of the rotation, with w at least 0
     */
    public static Rotation ofMatrix(
            double xx, double xy, double xz, double yx, double yy, double yz, double zx, double zy, double zz) {
        double w = 1 + xx + yy + zz;
        double x = 1 + xx - yy - zz;
        double y = 1 - xx + yy - zz;
        double z = 1 - xx - yy + zz;
        if (w >= 1) {
            return normalised(w, zy - yz, xz - zx, yx - xy);
        }
        if (x >= y && x >= z) {
            return normalised(zy - yz, x, xy + yx, xz + zx);
        }
        return y >= z ? normalised(xz - zx, xy + yx, y, yz + zy) : normalised(yx - xy, xz + zx, yz + zy, z);
    }

    private static Rotation normalised(double w, double x, double y, double z) {
        double factor = (w < 0 ? -1 : 1) / Math.sqrt(w * w + x * x + y * y + z * z);
        return new Rotation(w * factor, x * factor, y * factor, z * factor);
    }

    /**
     * Rotates a vector.
     *
     * @param vector the vector
     * @return the rotated vector, of the same length
     */
    public Vector3 apply(Vector3 vector) {
        double twiceX = 2 * (y * vector.z() - z * vector.y()); // twice the cross product of axis and vector
        double twiceY = 2 * (z * vector.x() - x * vector.z());
        double twiceZ = 2 * (x * vector.y() - y * vector.x());
        return new Vector3(
                vector.x() + w * twiceX + (y * twiceZ - z * twiceY),
                vector.y() + w * twiceY + (z * twiceX - x * twiceZ),
                vector.z() + w * twiceZ + (x * twiceY - y * twiceX));
    }

    /**
     * Composes two rotations.
     *
     * @param first the rotation that is applied first
     * @return the combined rotation
     */
    public Rotation times(Rotation first) {
        return new Rotation(
                w * first.w - x * first.x - y * first.y - z * first.z,
                w * first.x + x * first.w + y * first.z - z * first.y,
                w * first.y - x * first.z + y * first.w + z * first.x,
                w * first.z + x * first.y - y * first.x + z * first.w);
    }

    /** {@return the inverse rotation} */
    public Rotation inverse() {
        return new Rotation(w, -x, -y, -z);
    }

    /** {@return the angle of the rotation in degrees, 0 to 180} */
    public double angleDegrees() {
        return PortableMath.toDegrees(2 * PortableMath.atan2(Math.sqrt(x * x + y * y + z * z), Math.abs(w)));
    }

    /** {@return the direction of the rotated x axis as an angle about z in degrees, -180 to 180; positive is to the left} */
    public double yawDegrees() {
        return Angles.atan2(2 * (w * z + x * y), 1 - 2 * (y * y + z * z));
    }
}
