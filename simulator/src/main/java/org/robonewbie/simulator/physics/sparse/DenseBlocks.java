package org.robonewbie.simulator.physics.sparse;

/** Arithmetic on small dense matrices that are stored in one array, each in row-major order. */
final class DenseBlocks {

    private DenseBlocks() {}

    /**
     * target -= left · rightᵀ, where left is height × inner, right width × inner and target height × width. If left and
     * right are the same, the result is symmetric and only its lower half is computed.
     */
    static void subtractProduct(double[] m, int left, int right, int target, int height, int width, int inner) {
        if (inner == 6) {
            subtractProductOfSix(m, left, right, target, height, width);
            return;
        }
        for (int r = 0; r < height; r++) {
            int end = left == right ? r + 1 : width;
            for (int c = 0; c < end; c++) {
                double sum = 0;
                for (int i = 0; i < inner; i++) {
                    sum += m[left + r * inner + i] * m[right + c * inner + i];
                }
                m[target + r * width + c] -= sum;
            }
        }
    }

    /** The same for hinges, which have six rows. */
    private static void subtractProductOfSix(double[] m, int left, int right, int target, int height, int width) {
        for (int r = 0; r < height; r++) {
            int a = left + 6 * r;
            double a0 = m[a];
            double a1 = m[a + 1];
            double a2 = m[a + 2];
            double a3 = m[a + 3];
            double a4 = m[a + 4];
            double a5 = m[a + 5];
            int end = left == right ? r + 1 : width;
            for (int c = 0; c < end; c++) {
                int b = right + 6 * c;
                m[target + r * width + c] -=
                        a0 * m[b] + a1 * m[b + 1] + a2 * m[b + 2] + a3 * m[b + 3] + a4 * m[b + 4] + a5 * m[b + 5];
            }
        }
    }

    /** Turns row and column of a diagonal block, and the column in all that is below it, into those of a unit matrix. */
    static void replaceByUnit(double[] m, int start, int width, int height, int index) {
        for (int c = 0; c < index; c++) {
            m[start + index * width + c] = 0;
        }
        m[start + index * width + index] = 1;
        for (int r = index + 1; r < height; r++) {
            m[start + r * width + index] = 0;
        }
    }

    /** Cholesky factorisation of a diagonal block, of which only the lower half is read and written. */
    static void factorise(double[] m, int start, int width, double[] inverseDiagonal, int inverseStart) {
        for (int r = 0; r < width; r++) {
            int row = start + r * width;
            for (int c = 0; c < r; c++) {
                int other = start + c * width;
                double sum = m[row + c];
                for (int i = 0; i < c; i++) {
                    sum -= m[row + i] * m[other + i];
                }
                m[row + c] = sum * inverseDiagonal[inverseStart + c];
            }
            double square = m[row + r];
            for (int i = 0; i < r; i++) {
                square -= m[row + i] * m[row + i];
            }
            double root = Math.sqrt(square);
            m[row + r] = root;
            inverseDiagonal[inverseStart + r] = 1 / root;
        }
    }

    /** Multiplies all rows below a factorised diagonal block by the inverse of its transpose. */
    static void divide(double[] m, int start, int width, int height, double[] inverseDiagonal, int inverseStart) {
        for (int r = width; r < height; r++) {
            int row = start + r * width;
            for (int c = 0; c < width; c++) {
                int other = start + c * width;
                double sum = m[row + c];
                for (int i = 0; i < c; i++) {
                    sum -= m[row + i] * m[other + i];
                }
                m[row + c] = sum * inverseDiagonal[inverseStart + c];
            }
        }
    }

    static void solveForwards(double[] m, int start, int width, double[] inverseDiagonal, double[] x, int at) {
        for (int r = 0; r < width; r++) {
            double sum = x[at + r];
            for (int i = 0; i < r; i++) {
                sum -= m[start + r * width + i] * x[at + i];
            }
            x[at + r] = sum * inverseDiagonal[at + r];
        }
    }

    static void solveBackwards(double[] m, int start, int width, double[] inverseDiagonal, double[] x, int at) {
        for (int r = width - 1; r >= 0; r--) {
            double value = x[at + r] * inverseDiagonal[at + r];
            x[at + r] = value;
            for (int i = 0; i < r; i++) {
                x[at + i] -= m[start + r * width + i] * value;
            }
        }
    }

    /** x[to...] -= block · x[from...] for a block of height × width. */
    static void subtractTimes(double[] m, int start, int height, int width, double[] x, int from, int to) {
        if (width == 6) {
            subtractTimesSix(m, start, height, x, from, to);
            return;
        }
        for (int r = 0; r < height; r++) {
            double sum = 0;
            for (int i = 0; i < width; i++) {
                sum += m[start + r * width + i] * x[from + i];
            }
            x[to + r] -= sum;
        }
    }

    private static void subtractTimesSix(double[] m, int start, int height, double[] x, int from, int to) {
        for (int r = 0; r < height; r++) {
            int a = start + 6 * r;
            x[to + r] -= m[a] * x[from]
                    + m[a + 1] * x[from + 1]
                    + m[a + 2] * x[from + 2]
                    + m[a + 3] * x[from + 3]
                    + m[a + 4] * x[from + 4]
                    + m[a + 5] * x[from + 5];
        }
    }

    /** x[to...] -= blockᵀ · x[from...] for a block of height × width. */
    static void subtractTransposedTimes(double[] m, int start, int height, int width, double[] x, int from, int to) {
        for (int r = 0; r < height; r++) {
            double value = x[from + r];
            for (int i = 0; i < width; i++) {
                x[to + i] -= m[start + r * width + i] * value;
            }
        }
    }
}
