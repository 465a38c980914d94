package org.robonewbie.simulator.physics;

import org.robonewbie.nao.Vector3;
import org.robonewbie.nao.math.PortableMath;

/**
 * A rotation as matrix; the columns are the turned axes. Components are named by row and column.
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
     * Turns about the z axis.
     *
     * @param radians angle by the right-hand rule, counter-clockwise seen from above
     * @return the rotation
     */
    public static RotationMatrix aboutZ(double radians) {
        double cos = PortableMath.cos(radians);
        double sin = PortableMath.sin(radians);
        return new RotationMatrix(cos, -sin, 0, sin, cos, 0, 0, 0, 1);
    }

    /**
     * Creates the rotation of a quaternion.
     *
     * @param w real part
     * @param x first imaginary part
     * @param y second imaginary part
     * @param z third imaginary part; the length need not be exactly 1
     * @return the rotation; the identity for a quaternion of length 0
     */
    public static RotationMatrix ofQuaternion(double w, double x, double y, double z) {
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
     * Turns a vector.
     *
     * @param v any vector
     * @return the turned vector
     */
    public Vector3 apply(Vector3 v) {
        return new Vector3(
                xx * v.x() + xy * v.y() + xz * v.z(),
                yx * v.x() + yy * v.y() + yz * v.z(),
                zx * v.x() + zy * v.y() + zz * v.z());
    }

    /**
     * Turns a vector back.
     *
     * @param v any vector
     * @return the vector that {@link #apply} turns to v
     */
    public Vector3 applyInverse(Vector3 v) {
        return new Vector3(
                xx * v.x() + yx * v.y() + zx * v.z(),
                xy * v.x() + yy * v.y() + zy * v.z(),
                xz * v.x() + yz * v.y() + zz * v.z());
    }

    /**
     * Chains two rotations.
     *
     * @param first the rotation that is done first
     * @return the rotation that does both
     */
    public RotationMatrix after(RotationMatrix first) {
        Vector3 x = apply(first.axisX());
        Vector3 y = apply(first.axisY());
        Vector3 z = apply(first.axisZ());
        return new RotationMatrix(x.x(), y.x(), z.x(), x.y(), y.y(), z.y(), x.z(), y.z(), z.z());
    }

    /**
     * Turns the other way.
     *
     * @return the inverse rotation
     */
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

    /**
     * Writes the rotation as a quaternion of length 1.
     *
     * @return w, x, y, z with w at least 0
     */
    public double[] toQuaternion() {
        org.robonewbie.nao.kinematics.Rotation turn = toTurn();
        return new double[] {turn.w(), turn.x(), turn.y(), turn.z()};
    }

    /** {@return the same rotation as the quaternion of {@link #toQuaternion}} */
    public org.robonewbie.nao.kinematics.Rotation toTurn() {
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

    /**
     * Makes a rotation of a quaternion.
     *
     * @param quaternion the quaternion; its length need not be exactly 1
     * @return the same rotation
     */
    public static RotationMatrix of(org.robonewbie.nao.kinematics.Rotation quaternion) {
        return ofQuaternion(quaternion.w(), quaternion.x(), quaternion.y(), quaternion.z());
    }

    private static org.robonewbie.nao.kinematics.Rotation normalised(double w, double x, double y, double z) {
        double factor = (w < 0 ? -1 : 1) / Math.sqrt(w * w + x * x + y * y + z * z);
        return new org.robonewbie.nao.kinematics.Rotation(w * factor, x * factor, y * factor, z * factor);
    }
}
