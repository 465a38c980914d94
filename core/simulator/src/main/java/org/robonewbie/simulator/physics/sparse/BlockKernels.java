package org.robonewbie.simulator.physics.sparse;

/**
 * Dense kernels for small row-major matrices in a shared array. Heights and widths are multiples of three, as are the row
 * counts of all joints. Three rows are processed at a time, because their sums do not depend on one another and can be
 * computed in parallel by the processor.
 */
final class BlockKernels {

    private BlockKernels() {}

    /**
     * target -= left · rightᵀ, where left is height × inner, right is width × inner and target is height × width. If left and
     * right are the same block, the result is symmetric and its upper half is undefined.
     */
    static void subtractProduct(double[] m, int left, int right, int target, int height, int width, int inner) {
        if (inner == 6) {
            HingeKernels.subtractProduct(m, left, right, target, height, width);
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

    /**
     * Replaces a row and a column of a diagonal block, and the same column in the blocks below it, with those of the
     * identity matrix.
     */
    static void replaceByUnit(double[] m, int start, int width, int height, int index) {
        for (int c = 0; c < index; c++) {
            m[start + index * width + c] = 0;
        }
        m[start + index * width + index] = 1;
        for (int r = index + 1; r < height; r++) {
            m[start + r * width + index] = 0;
        }
    }

    /** Cholesky factorization of a block column, three columns at a time. The upper half of the diagonal block is ignored. */
    static void factorise(double[] m, int start, int width, int height, double[] inverseDiagonal, int inverseStart) {
        if (width == 6) {
            HingeKernels.factorise(m, start, start + 6 * height, inverseDiagonal, inverseStart);
            return;
        }
        int end = start + height * width;
        for (int c = 0; c < width; c += 3) {
            int corner = start + c * width + c;
            for (int done = c; done > 0; done -= 3) {
                subtractFinished(m, corner, width, end, done);
            }
            factoriseTile(m, corner, width, inverseDiagonal, inverseStart + c);
            divideByTile(m, corner, width, end, inverseDiagonal, inverseStart + c);
        }
    }

    /**
     * Subtracts the outer product of three finished columns, which lie the given distance to the left, from the three
     * columns below a corner.
     */
    private static void subtractFinished(double[] m, int corner, int width, int end, int distance) {
        int first = corner - distance;
        double a0 = m[first];
        double a1 = m[first + 1];
        double a2 = m[first + 2];
        int second = first + width;
        double b0 = m[second];
        double b1 = m[second + 1];
        double b2 = m[second + 2];
        int third = second + width;
        double c0 = m[third];
        double c1 = m[third + 1];
        double c2 = m[third + 2];
        for (int row = corner; row < end; row += width) {
            int finished = row - distance;
            double x = m[finished];
            double y = m[finished + 1];
            double z = m[finished + 2];
            m[row] = m[row] - x * a0 - y * a1 - z * a2;
            m[row + 1] = m[row + 1] - x * b0 - y * b1 - z * b2;
            m[row + 2] = m[row + 2] - x * c0 - y * c1 - z * c2;
        }
    }

    /** Cholesky factorization of a 3 × 3 tile. */
    private static void factoriseTile(double[] m, int corner, int width, double[] inverse, int at) {
        int second = corner + width;
        int third = second + width;
        m[corner] = Math.sqrt(m[corner]);
        inverse[at] = 1 / m[corner];
        double b0 = m[second] * inverse[at];
        m[second] = b0;
        m[second + 1] = Math.sqrt(m[second + 1] - b0 * b0);
        inverse[at + 1] = 1 / m[second + 1];
        double c0 = m[third] * inverse[at];
        double c1 = (m[third + 1] - c0 * b0) * inverse[at + 1];
        m[third] = c0;
        m[third + 1] = c1;
        m[third + 2] = Math.sqrt(m[third + 2] - c0 * c0 - c1 * c1);
        inverse[at + 2] = 1 / m[third + 2];
    }

    /** Multiplies the rows below a factorized 3 × 3 tile by the inverse transpose of the tile. */
    private static void divideByTile(double[] m, int corner, int width, int end, double[] inverse, int at) {
        double b0 = m[corner + width];
        double c0 = m[corner + 2 * width];
        double c1 = m[corner + 2 * width + 1];
        double inverseA = inverse[at];
        double inverseB = inverse[at + 1];
        double inverseC = inverse[at + 2];
        for (int row = corner + 3 * width; row < end; row += width) {
            double x = m[row] * inverseA;
            double y = (m[row + 1] - x * b0) * inverseB;
            m[row] = x;
            m[row + 1] = y;
            m[row + 2] = (m[row + 2] - x * c0 - y * c1) * inverseC;
        }
    }

    static void solveForwards(double[] m, int start, int width, double[] inverseDiagonal, double[] x, int at) {
        if (width == 6) {
            HingeKernels.solveForwards(m, start, inverseDiagonal, x, at);
            return;
        }
        for (int r = 0; r < width; r += 3) {
            int first = start + r * width;
            int second = first + width;
            int third = second + width;
            double a = x[at + r];
            double b = x[at + r + 1];
            double c = x[at + r + 2];
            for (int i = 0; i < r; i++) {
                double known = x[at + i];
                a -= m[first + i] * known;
                b -= m[second + i] * known;
                c -= m[third + i] * known;
            }
            a *= inverseDiagonal[at + r];
            b = (b - m[second + r] * a) * inverseDiagonal[at + r + 1];
            x[at + r] = a;
            x[at + r + 1] = b;
            x[at + r + 2] = (c - m[third + r] * a - m[third + r + 1] * b) * inverseDiagonal[at + r + 2];
        }
    }

    static void solveBackwards(double[] m, int start, int width, double[] inverseDiagonal, double[] x, int at) {
        if (width == 6) {
            HingeKernels.solveBackwards(m, start, inverseDiagonal, x, at);
            return;
        }
        for (int r = width - 3; r >= 0; r -= 3) {
            int first = start + r * width;
            int second = first + width;
            int third = second + width;
            double c = x[at + r + 2] * inverseDiagonal[at + r + 2];
            double b = (x[at + r + 1] - m[third + r + 1] * c) * inverseDiagonal[at + r + 1];
            double a = (x[at + r] - m[third + r] * c - m[second + r] * b) * inverseDiagonal[at + r];
            x[at + r] = a;
            x[at + r + 1] = b;
            x[at + r + 2] = c;
            for (int i = 0; i < r; i++) {
                x[at + i] = x[at + i] - m[third + i] * c - m[second + i] * b - m[first + i] * a;
            }
        }
    }

    /** x[to...] -= block · x[from...] for a block of height × width. */
    static void subtractTimes(double[] m, int start, int height, int width, double[] x, int from, int to) {
        if (width == 6) {
            HingeKernels.subtractTimes(m, start, height, x, from, to);
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

    /** x[to...] -= blockᵀ · x[from...] for a block of height × width. */
    static void subtractTransposedTimes(double[] m, int start, int height, int width, double[] x, int from, int to) {
        if (width == 6) {
            HingeKernels.subtractTransposedTimes(m, start, height, x, from, to);
            return;
        }
        for (int i = 0; i < width; i += 3) {
            double a = x[to + i];
            double b = x[to + i + 1];
            double c = x[to + i + 2];
            int row = start + i;
            for (int r = 0; r < height; r++) {
                double value = x[from + r];
                a -= m[row] * value;
                b -= m[row + 1] * value;
                c -= m[row + 2] * value;
                row += width;
            }
            x[to + i] = a;
            x[to + i + 1] = b;
            x[to + i + 2] = c;
        }
    }
}
