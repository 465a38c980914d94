package org.robonewbie.nao.math;

/** Hyperbolic functions, as in fdlibm (e_sinh.c, e_cosh.c, s_tanh.c). */
final class Hyperbolic {

    /** From here on, exp(-x) is negligible. */
    private static final double LARGE = 22;

    /** Up to here, exp(x) is finite; for a larger number, the square of exp(x / 2) may be. */
    private static final double EXP_IS_FINITE = 0x1.62e42p9;

    private static final double LARGEST = 710.4758600739439;

    private Hyperbolic() {}

    static double sinh(double x) {
        double magnitude = Math.abs(x);
        if (!(magnitude <= Double.MAX_VALUE) || magnitude < 0x1p-28) {
            return x;
        }
        double half = Math.copySign(0.5, x);
        if (magnitude >= LARGE) {
            return halfExp(half, magnitude);
        }
        double grown = ExponentialMinus1.expm1(magnitude);
        double rest = grown / (grown + 1);
        return half * (magnitude < 1 ? 2 * grown - grown * grown / (grown + 1) : grown + rest);
    }

    static double cosh(double x) {
        double magnitude = Math.abs(x);
        if (magnitude < 0x1.62e43p-2) {
            double grown = ExponentialMinus1.expm1(magnitude);
            double power = 1 + grown;
            return magnitude < 0x1p-55 ? power : 1 + grown * grown / (power + power);
        }
        if (magnitude < LARGE) {
            double power = Exponential.exp(magnitude);
            return 0.5 * power + 0.5 / power;
        }
        return magnitude <= Double.MAX_VALUE ? halfExp(0.5, magnitude) : magnitude;
    }

    private static double halfExp(double half, double magnitude) {
        if (magnitude < EXP_IS_FINITE) {
            return half * Exponential.exp(magnitude);
        }
        if (magnitude > LARGEST) {
            return half * Double.POSITIVE_INFINITY;
        }
        double root = Exponential.exp(0.5 * magnitude);
        return half * root * root;
    }

    static double tanh(double x) {
        double magnitude = Math.abs(x);
        if (magnitude < 0x1p-55) {
            return x * (1 + x);
        }
        return Double.isNaN(x) ? x : Math.copySign(tanhOf(magnitude), x);
    }

    private static double tanhOf(double magnitude) {
        if (magnitude >= LARGE) {
            return 1;
        }
        if (magnitude >= 1) {
            return 1 - 2 / (ExponentialMinus1.expm1(2 * magnitude) + 2);
        }
        double shrunk = ExponentialMinus1.expm1(-2 * magnitude);
        return -shrunk / (shrunk + 2);
    }
}
