package org.robonewbie.nao.math;

/** e to the power of x, minus 1, as in fdlibm (s_expm1.c): with x = n ln 2 + r, a rational function of r is scaled by 2^n. */
final class ExponentialMinus1 {

    private static final double LARGEST = 709.782712893384;
    private static final double ONE_OVER_LN2 = 1.4426950408889634;

    /** Below minus this number, the result is -1. */
    private static final double LARGE = 0x1.3687ap5;

    private static final double Q1 = -0.03333333333333313;
    private static final double Q2 = 0.0015873015872548146;
    private static final double Q3 = -7.93650757867488e-05;
    private static final double Q4 = 4.008217827329362e-06;
    private static final double Q5 = -2.0109921818362437e-07;

    private ExponentialMinus1() {}

    static double expm1(double x) {
        if (Double.isNaN(x) || Math.abs(x) < 0x1p-54) {
            return x;
        }
        if (x > LARGEST) {
            return Double.POSITIVE_INFINITY;
        }
        return x <= -LARGE ? -1 : reduced(x);
    }

    private static double reduced(double x) {
        int n = multipleOfLn2(x);
        double head = x - n * Exponential.LN2_HEAD;
        double tail = n * Exponential.LN2_TAIL;
        double r = head - tail;
        double half = 0.5 * r;
        double square = r * half;
        double rest = 1 + square * (Q1 + square * (Q2 + square * (Q3 + square * (Q4 + square * Q5))));
        double t = 3 - rest * half;
        double error = square * ((rest - t) / (6 - r * t));
        if (n == 0) {
            return r - (r * error - square);
        }
        double correction = (head - r) - tail;
        return scaled(r, r * (error - correction) - correction - square, n);
    }

    private static int multipleOfLn2(double x) {
        double magnitude = Math.abs(x);
        if (magnitude < 0x1.62e43p-2) {
            return 0;
        }
        return (int) (magnitude < 0x1.0a2b2p0 ? Math.copySign(1, x) : ONE_OVER_LN2 * x + Math.copySign(0.5, x));
    }

    /** Returns 2^n (1 + r - error) - 1; where 1 is subtracted depends on the size of 2^n. */
    private static double scaled(double r, double error, int n) {
        if (n == -1) {
            return 0.5 * (r - error) - 0.5;
        }
        if (n == 1) {
            return r < -0.25 ? -2 * (error - (r + 0.5)) : 1 + 2 * (r - error);
        }
        if (n < 0 || n > 56) {
            return Words.scale(1 - (error - r), n) - 1;
        }
        double one = Words.powerOfTwo(-n);
        return Words.scale(n < 20 ? (1 - one) - (error - r) : r - (error + one) + 1, n);
    }
}
