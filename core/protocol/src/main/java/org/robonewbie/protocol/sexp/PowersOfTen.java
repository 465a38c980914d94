package org.robonewbie.protocol.sexp;

/** The powers of ten that a double represents exactly. */
final class PowersOfTen {

    /** Maximum exponent: a double represents 10^22 exactly, but not 10^23. */
    static final int MAX = 22;

    private static final double[] POWERS = new double[MAX + 1];

    static {
        for (int i = 0; i <= MAX; i++) {
            POWERS[i] = Double.parseDouble("1e" + i);
        }
    }

    private PowersOfTen() {}

    static double get(int exponent) {
        return POWERS[exponent];
    }
}
