package org.robonewbie.nao.math;

/** The cube root, as in fdlibm (s_cbrt.c): an estimate from a third of the exponent, a rational correction and one Newton step. */
final class CubeRoot {

    private static final int NORMAL = 715_094_163;
    private static final int SUBNORMAL = 696_219_795;

    private static final double C = 19.0 / 35;
    private static final double D = -864.0 / 1225;
    private static final double E = 99.0 / 70;
    private static final double F = 45.0 / 28;
    private static final double G = 5.0 / 14;

    private CubeRoot() {}

    static double cbrt(double x) {
        double magnitude = Math.abs(x);
        return x == 0 || !(magnitude <= Double.MAX_VALUE) ? x : Math.copySign(positive(magnitude), x);
    }

    private static double positive(double x) {
        double near = estimate(x);
        double s = C + near * near / x * near;
        near *= G + F / (s + E + D / s);
        double above = Words.fromHigh(Words.high(near) + 1);
        double quotient = x / (above * above);
        return above + above * ((quotient - above) / (above + above + quotient));
    }

    /** Returns the root to 5 bits. */
    private static double estimate(double x) {
        if (x < Double.MIN_NORMAL) {
            double scaled = x * 0x1p54;
            return Words.withHigh(scaled, Words.high(scaled) / 3 + SUBNORMAL);
        }
        return Words.fromHigh(Words.high(x) / 3 + NORMAL);
    }
}
