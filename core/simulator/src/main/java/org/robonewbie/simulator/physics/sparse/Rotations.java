package org.robonewbie.simulator.physics.sparse;

import org.robonewbie.simulator.physics.RotationMatrix;

/**
 * Allocation-free operations on vectors, row-major 3 × 3 matrices and quaternions (w, x, y, z) in arrays. Code that is not in
 * the inner loop uses {@link RotationMatrix} instead.
 */
final class Rotations {

    private Rotations() {}

    static double[] identity() {
        return new double[] {1, 0, 0, 0, 1, 0, 0, 0, 1};
    }

    static double dot(double[] a, int aAt, double[] b, int bAt) {
        return a[aAt] * b[bAt] + a[aAt + 1] * b[bAt + 1] + a[aAt + 2] * b[bAt + 2];
    }

    static double dot(double x, double y, double z, double[] b, int at) {
        return x * b[at] + y * b[at + 1] + z * b[at + 2];
    }

    /** {@code to = matrixᵀ · (x, y, z)}, written starting at an index. */
    static void applyInverse(double[] matrix, double x, double y, double z, double[] to, int at) {
        for (int axis = 0; axis < 3; axis++) {
            to[at + axis] = matrix[axis] * x + matrix[3 + axis] * y + matrix[6 + axis] * z;
        }
    }

    /** {@code to = matrix · diag(x, y, z) · matrixᵀ}. */
    static void rotateDiagonal(double[] matrix, double x, double y, double z, double[] to) {
        for (int row = 0; row < 3; row++) {
            double rx = matrix[3 * row] * x;
            double ry = matrix[3 * row + 1] * y;
            double rz = matrix[3 * row + 2] * z;
            for (int column = 0; column <= row; column++) {
                double value = rx * matrix[3 * column] + ry * matrix[3 * column + 1] + rz * matrix[3 * column + 2];
                to[3 * row + column] = value;
                to[3 * column + row] = value;
            }
        }
    }

    /** Integrates an angular velocity (elements 3 to 5) into a quaternion, to first order as in ODE, and normalises it. */
    static void integrate(double[] q, double[] velocity, double seconds) {
        double half = 0.5 * seconds;
        double x = velocity[3];
        double y = velocity[4];
        double z = velocity[5];
        double q0 = q[0] + half * (-x * q[1] - y * q[2] - z * q[3]);
        double q1 = q[1] + half * (x * q[0] + y * q[3] - z * q[2]);
        double q2 = q[2] + half * (-x * q[3] + y * q[0] + z * q[1]);
        double q3 = q[3] + half * (x * q[2] - y * q[1] + z * q[0]);
        double factor = 1 / Math.sqrt(q0 * q0 + q1 * q1 + q2 * q2 + q3 * q3);
        q[0] = q0 * factor;
        q[1] = q1 * factor;
        q[2] = q2 * factor;
        q[3] = q3 * factor;
    }

    /**
     * Orthonormalises the rows of a matrix like ODE's {@code dOrthogonalizeR}. Prevents rounding errors from accumulating
     * when a rotation is multiplied repeatedly, for example when a sleeping robot is beamed in every cycle.
     */
    static void orthonormalise(double[] matrix) {
        if (Math.sqrt(dot(matrix, 0, matrix, 0)) != 1) {
            normalise(matrix, 0);
        }
        double along = dot(matrix, 0, matrix, 3);
        for (int i = 0; i < 3; i++) {
            matrix[3 + i] -= along * matrix[i];
        }
        if (dot(matrix, 3, matrix, 3) != 1) {
            normalise(matrix, 3);
        }
        matrix[6] = matrix[1] * matrix[5] - matrix[2] * matrix[4];
        matrix[7] = matrix[2] * matrix[3] - matrix[0] * matrix[5];
        matrix[8] = matrix[0] * matrix[4] - matrix[1] * matrix[3];
    }

    /** Normalises a row. Divides by its largest element first, so that rounding is the same as in ODE. */
    private static void normalise(double[] matrix, int row) {
        int largest = Math.abs(matrix[row + 1]) > Math.abs(matrix[row]) ? row + 1 : row;
        largest = Math.abs(matrix[row + 2]) > Math.abs(matrix[largest]) ? row + 2 : largest;
        double factor = 1 / Math.abs(matrix[largest]);
        double squares = 1;
        for (int i = row; i < row + 3; i++) {
            if (i != largest) {
                matrix[i] *= factor;
                squares += matrix[i] * matrix[i];
            }
        }
        double length = 1 / Math.sqrt(squares);
        for (int i = row; i < row + 3; i++) {
            matrix[i] = i == largest ? Math.copySign(length, matrix[i]) : matrix[i] * length;
        }
    }

    static void toMatrix(double[] q, double[] matrix) {
        double xx = 2 * q[1] * q[1];
        double yy = 2 * q[2] * q[2];
        double zz = 2 * q[3] * q[3];
        matrix[0] = 1 - yy - zz;
        matrix[1] = 2 * (q[1] * q[2] - q[0] * q[3]);
        matrix[2] = 2 * (q[1] * q[3] + q[0] * q[2]);
        matrix[3] = 2 * (q[1] * q[2] + q[0] * q[3]);
        matrix[4] = 1 - xx - zz;
        matrix[5] = 2 * (q[2] * q[3] - q[0] * q[1]);
        matrix[6] = 2 * (q[1] * q[3] - q[0] * q[2]);
        matrix[7] = 2 * (q[2] * q[3] + q[0] * q[1]);
        matrix[8] = 1 - xx - yy;
    }

    static void toQuaternion(double[] matrix, double[] q) {
        double trace = matrix[0] + matrix[4] + matrix[8];
        if (trace >= 0) {
            double root = Math.sqrt(trace + 1);
            double factor = 0.5 / root;
            q[0] = 0.5 * root;
            q[1] = (matrix[7] - matrix[5]) * factor;
            q[2] = (matrix[2] - matrix[6]) * factor;
            q[3] = (matrix[3] - matrix[1]) * factor;
        } else {
            fromLargestDiagonal(matrix, q);
        }
        double length = Math.sqrt(q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3]);
        for (int i = 0; i < 4; i++) {
            q[i] /= length;
        }
    }

    private static void fromLargestDiagonal(double[] matrix, double[] q) {
        int i = matrix[4] > matrix[0] ? 1 : 0;
        i = matrix[8] > matrix[4 * i] ? 2 : i;
        int j = (i + 1) % 3;
        int k = (i + 2) % 3;
        double root = Math.sqrt(matrix[4 * i] - (matrix[4 * j] + matrix[4 * k]) + 1);
        double factor = 0.5 / root;
        q[1 + i] = 0.5 * root;
        q[1 + j] = (matrix[3 * i + j] + matrix[3 * j + i]) * factor;
        q[1 + k] = (matrix[3 * k + i] + matrix[3 * i + k]) * factor;
        q[0] = (matrix[3 * k + j] - matrix[3 * j + k]) * factor;
    }

    static void copy(RotationMatrix from, double[] to) {
        to[0] = from.xx();
        to[1] = from.xy();
        to[2] = from.xz();
        to[3] = from.yx();
        to[4] = from.yy();
        to[5] = from.yz();
        to[6] = from.zx();
        to[7] = from.zy();
        to[8] = from.zz();
    }

    /** Extends a unit vector to an orthonormal basis like ODE's {@code dPlaneSpace}; arguments are array indices. */
    static void orthonormalBasis(double[] vectors, int normal, int one, int two) {
        double x = vectors[normal];
        double y = vectors[normal + 1];
        double z = vectors[normal + 2];
        if (Math.abs(z) > Math.sqrt(0.5)) {
            double square = y * y + z * z;
            double factor = 1 / Math.sqrt(square);
            double oneY = -z * factor;
            double oneZ = y * factor;
            set(vectors, one, 0, oneY, oneZ);
            set(vectors, two, square * factor, -x * oneZ, x * oneY);
        } else {
            double square = x * x + y * y;
            double factor = 1 / Math.sqrt(square);
            double oneX = -y * factor;
            double oneY = x * factor;
            set(vectors, one, oneX, oneY, 0);
            set(vectors, two, -z * oneY, z * oneX, square * factor);
        }
    }

    static void set(double[] vectors, int at, double x, double y, double z) {
        vectors[at] = x;
        vectors[at + 1] = y;
        vectors[at + 2] = z;
    }
}
