package org.robonewbie.nao.math;

/** A double seen as bits: sign, exponent and the first 20 bits of the fraction are its high word, 32 bits follow. */
final class Words {

    private static final int EXPONENT_BIAS = 1023;

    private Words() {}

    static int high(double x) {
        return (int) (Double.doubleToRawLongBits(x) >> 32);
    }

    static double withHigh(double x, int high) {
        return Double.longBitsToDouble(((long) high << 32) | (Double.doubleToRawLongBits(x) & 0xFFFF_FFFFL));
    }

    static double fromHigh(int high) {
        return Double.longBitsToDouble((long) high << 32);
    }

    /** The number without its low word: 21 significant bits, so that products of two such numbers are exact. */
    static double head(double x) {
        return Double.longBitsToDouble(Double.doubleToRawLongBits(x) & 0xFFFF_FFFF_0000_0000L);
    }

    /** 2 to the power of n, -1022 to 1023. */
    static double powerOfTwo(int n) {
        return Double.longBitsToDouble((long) (n + EXPONENT_BIAS) << 52);
    }

    /** x * 2^n, rounded once, for a normal x between 2^-500 and 2^500 and any n that may come out of exp and pow. */
    static double scale(double x, int n) {
        int half = n / 2;
        return x * powerOfTwo(half) * powerOfTwo(n - half);
    }
}
