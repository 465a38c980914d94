package org.robonewbie.nao.math;

/**
 * Logarithms, as in fdlibm (e_log.c, e_log10.c): x = 2^k (1 + f) with 1 + f between sqrt(1/2) and sqrt(2), and
 * log(1 + f) is a polynomial in s = f / (2 + f).
 */
final class Logarithm {

    private static final double L1 = 0.6666666666666735;
    private static final double L2 = 0.3999999999940942;
    private static final double L3 = 0.2857142874366239;
    private static final double L4 = 0.22222198432149784;
    private static final double L5 = 0.1818357216161805;
    private static final double L6 = 0.15313837699209373;
    private static final double L7 = 0.14798198605116586;

    private static final double ONE_OVER_LN10 = 0.4342944819032518;
    private static final double LOG10_OF_2_HEAD = 0.30102999566361177;
    private static final double LOG10_OF_2_TAIL = 3.694239077158931e-13;

    private static final int FRACTION = 0xfffff;
    private static final int ONE = 0x3ff00000;

    private Logarithm() {}

    static double log(double x) {
        if (!(x > 0) || x == Double.POSITIVE_INFINITY) {
            return special(x);
        }
        return x < Double.MIN_NORMAL ? logNormal(x * 0x1p54, -54) : logNormal(x, 0);
    }

    static double log10(double x) {
        if (!(x > 0) || x == Double.POSITIVE_INFINITY) {
            return special(x);
        }
        return x < Double.MIN_NORMAL ? log10Normal(x * 0x1p54, -54) : log10Normal(x, 0);
    }

    private static double special(double x) {
        if (x == 0) {
            return Double.NEGATIVE_INFINITY;
        }
        return x > 0 ? x : Double.NaN;
    }

    private static double log10Normal(double x, int scale) {
        int exponent = scale + (Words.high(x) >> 20) - 1023;
        int below = exponent < 0 ? 1 : 0;
        double near1 = Words.withHigh(x, (Words.high(x) & FRACTION) | ((1023 - below) << 20));
        double n = exponent + below;
        return n * LOG10_OF_2_TAIL + ONE_OVER_LN10 * log(near1) + n * LOG10_OF_2_HEAD;
    }

    private static double logNormal(double x, int scale) {
        int high = Words.high(x);
        int fraction = high & FRACTION;
        int above = (fraction + 0x95f64) & 0x100000;
        double f = Words.withHigh(x, fraction | (above ^ ONE)) - 1.0;
        double k = scale + (high >> 20) - 1023 + (above >> 20);
        if ((FRACTION & (2 + fraction)) < 3) {
            return logCloseTo1(f, k);
        }
        return logPolynomial(f, k, ((fraction - 0x6147a) | (0x6b851 - fraction)) > 0);
    }

    private static double logCloseTo1(double f, double k) {
        if (f == 0) {
            return k * Exponential.LN2_HEAD + k * Exponential.LN2_TAIL;
        }
        double bend = f * f * (0.5 - 0.3333333333333333 * f);
        return k * Exponential.LN2_HEAD - ((bend - k * Exponential.LN2_TAIL) - f);
    }

    private static double logPolynomial(double f, double k, boolean squareApart) {
        double s = f / (2.0 + f);
        double square = s * s;
        double fourth = square * square;
        double even = fourth * (L2 + fourth * (L4 + fourth * L6));
        double odd = square * (L1 + fourth * (L3 + fourth * (L5 + fourth * L7)));
        double rest = odd + even;
        double head = k * Exponential.LN2_HEAD;
        double tail = k * Exponential.LN2_TAIL;
        if (squareApart) {
            double halfSquare = 0.5 * f * f;
            return head - ((halfSquare - (s * (halfSquare + rest) + tail)) - f);
        }
        return head - ((s * (f - rest) - tail) - f);
    }
}
