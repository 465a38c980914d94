package org.robonewbie.nao.math;

/** Access to the 32-bit words of a double. The high word contains the sign, the exponent and the first 20 bits of the fraction. */
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

    /** Clears the low word, which leaves 21 significant bits, so that the product of two such numbers is exact. */
    static double head(double x) {
        return Double.longBitsToDouble(Double.doubleToRawLongBits(x) & 0xFFFF_FFFF_0000_0000L);
    }

    /** Returns 2^n for n from -1022 to 1023. */
    static double powerOfTwo(int n) {
        return Double.longBitsToDouble((long) (n + EXPONENT_BIAS) << 52);
    }

    /** Returns x * 2^n, rounded once, for a normal x between 2^-500 and 2^500 and any n that exp and pow produce. */
    static double scale(double x, int n) {
        int half = n / 2;
        return x * powerOfTwo(half) * powerOfTwo(n - half);
    }
}
