package org.robonewbie.nao;

import java.io.Serializable;

/**
 * A point or direction in space; components are in metres unless stated otherwise.
 *
 * <p>In this framework x points forward, y to the left and z up. Code that uses SimSpark's own frame (x right, y
 * forward, z up) is documented as such.
 *
 * @param x first component
 * @param y second component
 * @param z third component
 */
public record Vector3(double x, double y, double z) implements Serializable {

    /** The vector (0, 0, 0). */
    public static final Vector3 ZERO = new Vector3(0, 0, 0);

    /**
     * Returns the sum of this vector and another one.
     *
     * @param other the vector to add
     * @return this + other
     */
    public Vector3 plus(Vector3 other) {
        return new Vector3(x + other.x, y + other.y, z + other.z);
    }

    /**
     * Returns the difference between this vector and another one.
     *
     * @param other the vector to subtract
     * @return this - other
     */
    public Vector3 minus(Vector3 other) {
        return new Vector3(x - other.x, y - other.y, z - other.z);
    }

    /**
     * Returns this vector scaled by a factor.
     *
     * @param factor the factor for each component
     * @return factor * this
     */
    public Vector3 times(double factor) {
        return new Vector3(factor * x, factor * y, factor * z);
    }

    /**
     * Returns the dot product, which is 0 for perpendicular vectors.
     *
     * @param other the second factor
     * @return the dot product
     */
    public double dot(Vector3 other) {
        return x * other.x + y * other.y + z * other.z;
    }

    /**
     * Returns the cross product, which is perpendicular to both vectors.
     *
     * @param other the second factor
     * @return this × other
     */
    public Vector3 cross(Vector3 other) {
        return new Vector3(y * other.z - z * other.y, z * other.x - x * other.z, x * other.y - y * other.x);
    }

    /** {@return the length of this vector, at least 0} */
    public double length() {
        return Math.sqrt(dot(this));
    }

    /**
     * Returns the distance to another point.
     *
     * @param other the other point
     * @return the distance in the unit of the components
     */
    public double distanceTo(Vector3 other) {
        return minus(other).length();
    }
}
