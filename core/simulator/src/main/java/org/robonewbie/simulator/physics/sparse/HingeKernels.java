package org.robonewbie.simulator.physics.sparse;

/**
 * {@link BlockKernels} unrolled for hinges, which have six rows, so that a block stays in registers. Nearly all joints of
 * a robot are hinges. Terms are summed in the same order as in the general kernels.
 */
final class HingeKernels {

    private HingeKernels() {}

    /** Like {@link BlockKernels#subtractProduct} with six inner columns. */
    static void subtractProduct(double[] m, int left, int right, int target, int height, int width) {
        for (int r = 0; r < height; r += 3) {
            int a = left + 6 * r;
            double a0 = m[a];
            double a1 = m[a + 1];
            double a2 = m[a + 2];
            double a3 = m[a + 3];
            double a4 = m[a + 4];
            double a5 = m[a + 5];
            double b0 = m[a + 6];
            double b1 = m[a + 7];
            double b2 = m[a + 8];
            double b3 = m[a + 9];
            double b4 = m[a + 10];
            double b5 = m[a + 11];
            double c0 = m[a + 12];
            double c1 = m[a + 13];
            double c2 = m[a + 14];
            double c3 = m[a + 15];
            double c4 = m[a + 16];
            double c5 = m[a + 17];
            int end = left == right ? r + 3 : width;
            int to = target + r * width;
            int with = right;
            for (int c = 0; c < end; c++) {
                double d0 = m[with];
                double d1 = m[with + 1];
                double d2 = m[with + 2];
                double d3 = m[with + 3];
                double d4 = m[with + 4];
                double d5 = m[with + 5];
                m[to + c] -= a0 * d0 + a1 * d1 + a2 * d2 + a3 * d3 + a4 * d4 + a5 * d5;
                m[to + width + c] -= b0 * d0 + b1 * d1 + b2 * d2 + b3 * d3 + b4 * d4 + b5 * d5;
                m[to + 2 * width + c] -= c0 * d0 + c1 * d1 + c2 * d2 + c3 * d3 + c4 * d4 + c5 * d5;
                with += 6;
            }
        }
    }

    /**
     * target += rows · responsesᵀ for the six Jacobian rows of a hinge. Each of the first three constrains a point: its linear
     * part is along one world axis and its angular part has two components. The last three are purely angular.
     *
     * @param columns number of leading target columns that need all rows; the others need only the last three
     */
    static void addTimes(
            double[] m, int target, int width, int columns, double[] rows, int at, double[] responses, int from) {
        double along = rows[at];
        double y0 = rows[at + 4];
        double z0 = rows[at + 5];
        double x1 = rows[at + 9];
        double z1 = rows[at + 11];
        double x2 = rows[at + 15];
        double y2 = rows[at + 16];
        double x3 = rows[at + 21];
        double y3 = rows[at + 22];
        double z3 = rows[at + 23];
        double x4 = rows[at + 27];
        double y4 = rows[at + 28];
        double z4 = rows[at + 29];
        double x5 = rows[at + 33];
        double y5 = rows[at + 34];
        double z5 = rows[at + 35];
        int b = from;
        for (int to = target; to < target + columns; to++) {
            double x = responses[b + 3];
            double y = responses[b + 4];
            double z = responses[b + 5];
            m[to] += along * responses[b] + y0 * y + z0 * z;
            m[to + width] += along * responses[b + 1] + x1 * x + z1 * z;
            m[to + 2 * width] += along * responses[b + 2] + x2 * x + y2 * y;
            m[to + 3 * width] += x3 * x + y3 * y + z3 * z;
            m[to + 4 * width] += x4 * x + y4 * y + z4 * z;
            m[to + 5 * width] += x5 * x + y5 * y + z5 * z;
            b += 6;
        }
        for (int to = target + columns; to < target + width; to++) {
            double x = responses[b + 3];
            double y = responses[b + 4];
            double z = responses[b + 5];
            m[to + 3 * width] += x3 * x + y3 * y + z3 * z;
            m[to + 4 * width] += x4 * x + y4 * y + z4 * z;
            m[to + 5 * width] += x5 * x + y5 * y + z5 * z;
            b += 6;
        }
    }

    /**
     * Like {@link BlockKernels#factorise}, but the processor can compute the first three columns of the rows below while
     * it is still computing the square roots and reciprocals of the other three.
     */
    static void factorise(double[] m, int start, int end, double[] inverse, int at) {
        double a = Math.sqrt(m[start]);
        double inverseA = 1 / a;
        double b0 = m[start + 6] * inverseA;
        double b = Math.sqrt(m[start + 7] - b0 * b0);
        double inverseB = 1 / b;
        double c0 = m[start + 12] * inverseA;
        double c1 = (m[start + 13] - c0 * b0) * inverseB;
        double c = Math.sqrt(m[start + 14] - c0 * c0 - c1 * c1);
        double inverseC = 1 / c;
        double d0 = m[start + 18] * inverseA;
        double d1 = (m[start + 19] - d0 * b0) * inverseB;
        double d2 = (m[start + 20] - d0 * c0 - d1 * c1) * inverseC;
        double e0 = m[start + 24] * inverseA;
        double e1 = (m[start + 25] - e0 * b0) * inverseB;
        double e2 = (m[start + 26] - e0 * c0 - e1 * c1) * inverseC;
        double f0 = m[start + 30] * inverseA;
        double f1 = (m[start + 31] - f0 * b0) * inverseB;
        double f2 = (m[start + 32] - f0 * c0 - f1 * c1) * inverseC;
        double d = Math.sqrt(m[start + 21] - d0 * d0 - d1 * d1 - d2 * d2);
        double inverseD = 1 / d;
        double e3 = (m[start + 27] - e0 * d0 - e1 * d1 - e2 * d2) * inverseD;
        double e = Math.sqrt(m[start + 28] - e0 * e0 - e1 * e1 - e2 * e2 - e3 * e3);
        double inverseE = 1 / e;
        double f3 = (m[start + 33] - f0 * d0 - f1 * d1 - f2 * d2) * inverseD;
        double f4 = (m[start + 34] - f0 * e0 - f1 * e1 - f2 * e2 - f3 * e3) * inverseE;
        double f = Math.sqrt(m[start + 35] - f0 * f0 - f1 * f1 - f2 * f2 - f3 * f3 - f4 * f4);
        double inverseF = 1 / f;
        for (int row = start + 36; row < end; row += 6) {
            double x = m[row] * inverseA;
            double y = (m[row + 1] - x * b0) * inverseB;
            double z = (m[row + 2] - x * c0 - y * c1) * inverseC;
            double u = (m[row + 3] - x * d0 - y * d1 - z * d2) * inverseD;
            double v = (m[row + 4] - x * e0 - y * e1 - z * e2 - u * e3) * inverseE;
            m[row] = x;
            m[row + 1] = y;
            m[row + 2] = z;
            m[row + 3] = u;
            m[row + 4] = v;
            m[row + 5] = (m[row + 5] - x * f0 - y * f1 - z * f2 - u * f3 - v * f4) * inverseF;
        }
        m[start] = a;
        m[start + 6] = b0;
        m[start + 7] = b;
        m[start + 12] = c0;
        m[start + 13] = c1;
        m[start + 14] = c;
        m[start + 18] = d0;
        m[start + 19] = d1;
        m[start + 20] = d2;
        m[start + 21] = d;
        m[start + 24] = e0;
        m[start + 25] = e1;
        m[start + 26] = e2;
        m[start + 27] = e3;
        m[start + 28] = e;
        m[start + 30] = f0;
        m[start + 31] = f1;
        m[start + 32] = f2;
        m[start + 33] = f3;
        m[start + 34] = f4;
        m[start + 35] = f;
        inverse[at] = inverseA;
        inverse[at + 1] = inverseB;
        inverse[at + 2] = inverseC;
        inverse[at + 3] = inverseD;
        inverse[at + 4] = inverseE;
        inverse[at + 5] = inverseF;
    }

    static void solveForwards(double[] m, int start, double[] inverseDiagonal, double[] x, int at) {
        double a = x[at] * inverseDiagonal[at];
        double b = (x[at + 1] - m[start + 6] * a) * inverseDiagonal[at + 1];
        double c = (x[at + 2] - m[start + 12] * a - m[start + 13] * b) * inverseDiagonal[at + 2];
        double d = x[at + 3] - m[start + 18] * a - m[start + 19] * b - m[start + 20] * c;
        double e = x[at + 4] - m[start + 24] * a - m[start + 25] * b - m[start + 26] * c;
        double f = x[at + 5] - m[start + 30] * a - m[start + 31] * b - m[start + 32] * c;
        d *= inverseDiagonal[at + 3];
        e = (e - m[start + 27] * d) * inverseDiagonal[at + 4];
        x[at] = a;
        x[at + 1] = b;
        x[at + 2] = c;
        x[at + 3] = d;
        x[at + 4] = e;
        x[at + 5] = (f - m[start + 33] * d - m[start + 34] * e) * inverseDiagonal[at + 5];
    }

    static void solveBackwards(double[] m, int start, double[] inverseDiagonal, double[] x, int at) {
        double f = x[at + 5] * inverseDiagonal[at + 5];
        double e = (x[at + 4] - m[start + 34] * f) * inverseDiagonal[at + 4];
        double d = (x[at + 3] - m[start + 33] * f - m[start + 27] * e) * inverseDiagonal[at + 3];
        double a = x[at] - m[start + 30] * f - m[start + 24] * e - m[start + 18] * d;
        double b = x[at + 1] - m[start + 31] * f - m[start + 25] * e - m[start + 19] * d;
        double c = x[at + 2] - m[start + 32] * f - m[start + 26] * e - m[start + 20] * d;
        c *= inverseDiagonal[at + 2];
        b = (b - m[start + 13] * c) * inverseDiagonal[at + 1];
        x[at] = (a - m[start + 12] * c - m[start + 6] * b) * inverseDiagonal[at];
        x[at + 1] = b;
        x[at + 2] = c;
        x[at + 3] = d;
        x[at + 4] = e;
        x[at + 5] = f;
    }

    static void subtractTimes(double[] m, int start, int height, double[] x, int from, int to) {
        double a = x[from];
        double b = x[from + 1];
        double c = x[from + 2];
        double d = x[from + 3];
        double e = x[from + 4];
        double f = x[from + 5];
        for (int r = 0; r < height; r++) {
            int at = start + 6 * r;
            x[to + r] -= m[at] * a + m[at + 1] * b + m[at + 2] * c + m[at + 3] * d + m[at + 4] * e + m[at + 5] * f;
        }
    }

    static void subtractTransposedTimes(double[] m, int start, int height, double[] x, int from, int to) {
        double a = x[to];
        double b = x[to + 1];
        double c = x[to + 2];
        double d = x[to + 3];
        double e = x[to + 4];
        double f = x[to + 5];
        for (int r = 0; r < height; r++) {
            int at = start + 6 * r;
            double value = x[from + r];
            a -= m[at] * value;
            b -= m[at + 1] * value;
            c -= m[at + 2] * value;
            d -= m[at + 3] * value;
            e -= m[at + 4] * value;
            f -= m[at + 5] * value;
        }
        x[to] = a;
        x[to + 1] = b;
        x[to + 2] = c;
        x[to + 3] = d;
        x[to + 4] = e;
        x[to + 5] = f;
    }
}
