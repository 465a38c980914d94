package org.robonewbie.nao.math;

/** The logarithm of 1 + x, as in fdlibm (s_log1p.c): that of the rounded sum, corrected by the rounding error. */
final class Logarithm1p {

    private static final double L1 = 0.6666666666666735;
    private static final double L2 = 0.3999999999940942;
    private static final double L3 = 0.2857142874366239;
    private static final double L4 = 0.22222198432149784;
    private static final double L5 = 0.1818357216161805;
    private static final double L6 = 0.15313837699209373;
    private static final double L7 = 0.14798198605116586;

    private static final int FRACTION = 0xfffff;
    private static final int ROOT_OF_2 = 0x6a09e;

    private Logarithm1p() {}

    static double log1p(double x) {
        if (!(x > -1)) {
            return x == -1 ? Double.NEGATIVE_INFINITY : Double.NaN;
        }
        double magnitude = Math.abs(x);
        if (magnitude < 0x1p-29) {
            return magnitude < 0x1p-54 ? x : x - x * x * 0.5;
        }
        if (x == Double.POSITIVE_INFINITY) {
            return x;
        }
        boolean isNearZero = x > 0 ? Words.high(x) < 0x3fda827a : Words.high(x) <= 0xbfd2bec3;
        return isNearZero ? polynomial(x, 0, 0) : reduced(x);
    }

    private static double reduced(double x) {
        boolean isLarge = x >= 0x1p53;
        double sum = isLarge ? x : 1 + x;
        int exponent = (Words.high(sum) >> 20) - 1023;
        double error = exponent > 0 ? 1 - (sum - x) : x - (sum - 1);
        double correction = isLarge ? 0 : error / sum;
        int fraction = Words.high(sum) & FRACTION;
        int above = fraction < ROOT_OF_2 ? 0 : 1;
        double f = Words.withHigh(sum, fraction | ((1023 - above) << 20)) - 1;
        int k = exponent + above;
        boolean isNear1 = above == 0 ? fraction == 0 : (0x100000 - fraction) >> 2 == 0;
        return isNear1 ? near1(f, k, correction) : polynomial(f, k, correction);
    }

    private static double near1(double f, int k, double correction) {
        double tail = k * Exponential.LN2_TAIL + correction;
        if (f == 0) {
            return k == 0 ? 0 : k * Exponential.LN2_HEAD + (correction + k * Exponential.LN2_TAIL);
        }
        double bend = 0.5 * f * f * (1 - 0.6666666666666666 * f);
        return k == 0 ? f - bend : k * Exponential.LN2_HEAD - ((bend - tail) - f);
    }

    private static double polynomial(double f, int k, double correction) {
        double halfSquare = 0.5 * f * f;
        double s = f / (2 + f);
        double z = s * s;
        double rest = z * (L1 + z * (L2 + z * (L3 + z * (L4 + z * (L5 + z * (L6 + z * L7))))));
        double product = s * (halfSquare + rest);
        if (k == 0) {
            return f - (halfSquare - product);
        }
        double tail = k * Exponential.LN2_TAIL + correction;
        return k * Exponential.LN2_HEAD - ((halfSquare - (product + tail)) - f);
    }
}
