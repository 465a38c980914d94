package org.robonewbie.nao.math;

/** Rounding to integers, exact remainders and rounding errors. */
final class Rounding {

    /** Magnitude at and above which every double is an integer. */
    private static final double WHOLE = 0x1p52;

    /** Factor for Veltkamp's splitting of a double into halves (1968). */
    private static final double SPLITTER = 0x1p27 + 1;

    private Rounding() {}

    static double rint(double x) {
        double magnitude = Math.abs(x);
        return magnitude < WHOLE ? Math.copySign((magnitude + WHOLE) - WHOLE, x) : x;
    }

    static long round(double x) {
        double below = Math.floor(x);
        return (long) (x - below >= 0.5 ? below + 1 : below);
    }

    /** Binary long division. Each subtraction is exact, because the remainder is less than twice the subtrahend. */
    static double remainder(double dividend, double divisor) {
        double rest = Math.abs(dividend);
        double unit = Math.abs(divisor);
        if (!(rest <= Double.MAX_VALUE) || !(unit > 0)) {
            return Double.NaN;
        }
        if (Double.isInfinite(divisor)) {
            return dividend;
        }
        boolean odd = false;
        for (double part = largestPart(rest, unit); part >= unit; part /= 2) {
            odd = rest >= part;
            rest -= odd ? part : 0;
        }
        double nearest = rest > unit - rest || (rest == unit - rest && odd) ? rest - unit : rest;
        return Math.copySign(1, dividend) < 0 ? -nearest : nearest;
    }

    private static double largestPart(double dividend, double unit) {
        double part = unit;
        while (part <= dividend / 2) {
            part *= 2;
        }
        return part;
    }

    static double productError(double a, double b) {
        double product = a * b;
        double aHead = head(a);
        double bHead = head(b);
        double aTail = a - aHead;
        double bTail = b - bHead;
        return aTail * bTail - (((product - aHead * bHead) - aTail * bHead) - aHead * bTail);
    }

    private static double head(double x) {
        double shifted = SPLITTER * x;
        return shifted - (shifted - x);
    }
}
