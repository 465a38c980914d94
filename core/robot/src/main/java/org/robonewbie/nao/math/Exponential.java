package org.robonewbie.nao.math;

/**
 * The exponential function, as in fdlibm (e_exp.c): with x = n ln 2 + r, the result is 2^n times a rational function of
 * r, which is also used by {@link Power}.
 */
final class Exponential {

    static final double LN2_HEAD = 0.6931471803691238;
    static final double LN2_TAIL = 1.9082149292705877e-10;

    private static final double LARGEST = 709.782712893384;
    private static final double SMALLEST = -745.1332191019411;
    private static final double ONE_OVER_LN2 = 1.4426950408889634;

    private static final double P1 = 0.16666666666666602;
    private static final double P2 = -0.0027777777777015593;
    private static final double P3 = 6.613756321437934e-05;
    private static final double P4 = -1.6533902205465252e-06;
    private static final double P5 = 4.1381367970572385e-08;

    private Exponential() {}

    static double exp(double x) {
        if (Double.isNaN(x) || x > LARGEST) {
            return x * Double.POSITIVE_INFINITY;
        }
        if (x < SMALLEST) {
            return 0;
        }
        return Math.abs(x) < 0x1.62e43p-2 ? expNearZero(x) : expReduced(x);
    }

    private static double expNearZero(double x) {
        if (Math.abs(x) < 0x1p-28) {
            return 1 + x;
        }
        double rest = withoutBend(x);
        return 1 - ((x * rest) / (rest - 2.0) - x);
    }

    private static double expReduced(double x) {
        int n = (int) (ONE_OVER_LN2 * x + Math.copySign(0.5, x));
        double head = x - n * LN2_HEAD;
        double tail = n * LN2_TAIL;
        double reduced = head - tail;
        double rest = withoutBend(reduced);
        return Words.scale(1 - ((tail - (reduced * rest) / (2.0 - rest)) - head), n);
    }

    /** Returns a polynomial approximation of c = 2 - 2 x / (exp(x) - 1), so exp(x) = 1 + 2 x / (2 - c) for x near 0. */
    static double withoutBend(double x) {
        double square = x * x;
        return x - square * (P1 + square * (P2 + square * (P3 + square * (P4 + square * P5))));
    }
}
