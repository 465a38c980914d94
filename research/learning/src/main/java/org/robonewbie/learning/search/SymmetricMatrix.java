package org.robonewbie.learning.search;

/**
 * Eigendecomposition of a symmetric matrix: V · diag(values) · Vᵀ.
 *
 * <p>Source: the cyclic Jacobi method (Golub and Van Loan, Matrix Computations, section 8.5), which is simple, accurate,
 * and fast enough for a few dozen rows.
 */
final class SymmetricMatrix {

    private static final int MAX_SWEEPS = 50;

    private final int size;
    private final double[][] matrix;
    private final double[][] axes;

    private SymmetricMatrix(double[][] source) {
        size = source.length;
        matrix = new double[size][];
        axes = new double[size][size];
        for (int i = 0; i < size; i++) {
            matrix[i] = source[i].clone();
            axes[i][i] = 1;
        }
    }

    /** Decomposes a symmetric matrix, which is not modified. */
    static SymmetricMatrix decompose(double[][] source) {
        SymmetricMatrix result = new SymmetricMatrix(source);
        for (int sweep = 0; sweep < MAX_SWEEPS && !result.isDiagonal(); sweep++) {
            result.sweep();
        }
        return result;
    }

    /** Returns the eigenvalue for a column of V. */
    double value(int column) {
        return matrix[column][column];
    }

    /** Returns a component of the unit eigenvector in a column of V. */
    double axis(int row, int column) {
        return axes[row][column];
    }

    private boolean isDiagonal() {
        double offDiagonal = 0;
        double diagonal = 0;
        for (int i = 0; i < size; i++) {
            diagonal += matrix[i][i] * matrix[i][i];
            for (int j = 0; j < i; j++) {
                offDiagonal += matrix[i][j] * matrix[i][j];
            }
        }
        return offDiagonal <= 1e-24 * diagonal;
    }

    private void sweep() {
        for (int p = 0; p < size - 1; p++) {
            for (int q = p + 1; q < size; q++) {
                if (matrix[p][q] != 0) {
                    rotate(p, q);
                }
            }
        }
    }

    private void rotate(int p, int q) {
        double theta = (matrix[q][q] - matrix[p][p]) / (2 * matrix[p][q]);
        double tangent = Math.copySign(1, theta) / (Math.abs(theta) + Math.hypot(theta, 1));
        double cosine = 1 / Math.hypot(tangent, 1);
        double sine = tangent * cosine;
        for (int k = 0; k < size; k++) {
            double kp = matrix[k][p];
            double kq = matrix[k][q];
            matrix[k][p] = cosine * kp - sine * kq;
            matrix[k][q] = sine * kp + cosine * kq;
        }
        for (int k = 0; k < size; k++) {
            double pk = matrix[p][k];
            double qk = matrix[q][k];
            matrix[p][k] = cosine * pk - sine * qk;
            matrix[q][k] = sine * pk + cosine * qk;
            double kp = axes[k][p];
            double kq = axes[k][q];
            axes[k][p] = cosine * kp - sine * kq;
            axes[k][q] = sine * kp + cosine * kq;
        }
    }
}
