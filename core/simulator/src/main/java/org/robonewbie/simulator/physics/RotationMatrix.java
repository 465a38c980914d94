package org.robonewbie.simulator.physics;

import org.robonewbie.nao.Vector3;
import org.robonewbie.nao.kinematics.Rotation;
import org.robonewbie.nao.math.PortableMath;

/**
 * Rotation matrix whose columns are the rotated axes. Elements are named by row and column.
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
 */
public record RotationMatrix(
        double xx, double xy, double xz, double yx, double yy, double yz, double zx, double zy, double zz) {

    /** The identity rotation. */
    public static final RotationMatrix IDENTITY = new RotationMatrix(1, 0, 0, 0, 1, 0, 0, 0, 1);

    /**
     * Creates a rotation about the z axis.
     *
     * @param radians angle by the right-hand rule, counter-clockwise as seen from above
     * @return the rotation
     */
    public static RotationMatrix aboutZ(double radians) {
        double cos = PortableMath.cos(radians);
        double sin = PortableMath.sin(radians);
        return new RotationMatrix(cos, -sin, 0, sin, cos, 0, 0, 0, 1);
    }

    /**
     * Converts a quaternion.
     *
     * @param quaternion a quaternion, not necessarily of unit length
     * @return the rotation; the identity for a quaternion of length 0
     */
    public static RotationMatrix of(Rotation quaternion) {
        double w = quaternion.w();
        double x = quaternion.x();
        double y = quaternion.y();
        double z = quaternion.z();
        double square = w * w + x * x + y * y + z * z;
        if (!(square > 0)) {
            return IDENTITY;
        }
        double s = 2 / square;
        return new RotationMatrix(
                1 - s * (y * y + z * z),
                s * (x * y - w * z),
                s * (x * z + w * y),
                s * (x * y + w * z),
                1 - s * (x * x + z * z),
                s * (y * z - w * x),
                s * (x * z - w * y),
                s * (y * z + w * x),
                1 - s * (x * x + y * y));
    }

    /**
     * Rotates a vector.
     *
     * @param v a vector
     * @return the rotated vector
     */
    public Vector3 apply(Vector3 v) {
        return new Vector3(
                xx * v.x() + xy * v.y() + xz * v.z(),
                yx * v.x() + yy * v.y() + yz * v.z(),
                zx * v.x() + zy * v.y() + zz * v.z());
    }

    /**
     * Composes two rotations.
     *
     * @param first the rotation that is applied first
     * @return the product of this rotation and {@code first}
     */
    public RotationMatrix after(RotationMatrix first) {
        Vector3 x = apply(first.axisX());
        Vector3 y = apply(first.axisY());
        Vector3 z = apply(first.axisZ());
        return new RotationMatrix(x.x(), y.x(), z.x(), x.y(), y.y(), z.y(), x.z(), y.z(), z.z());
    }

    /** {@return the inverse rotation} */
    public RotationMatrix inverse() {
        return new RotationMatrix(xx, yx, zx, xy, yy, zy, xz, yz, zz);
    }

    /** {@return the direction of the rotated x axis, the first column} */
    public Vector3 axisX() {
        return new Vector3(xx, yx, zx);
    }

    /** {@return the direction of the rotated y axis, the second column} */
    public Vector3 axisY() {
        return new Vector3(xy, yy, zy);
    }

    /** {@return the direction of the rotated z axis, the third column} */
    public Vector3 axisZ() {
        return new Vector3(xz, yz, zz);
    }

    /** {@return the unit quaternion of this rotation, with w at least 0} */
    public Rotation toQuaternion() {
        return Rotation.ofMatrix(xx, xy, xz, yx, yy, yz, zx, zy, zz);
    }
}
