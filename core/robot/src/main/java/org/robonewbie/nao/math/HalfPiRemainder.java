package org.robonewbie.nao.math;

import java.math.BigInteger;

/**
 * Argument reduction: the remainder of an angle after subtracting the nearest multiple of pi/2.
 *
 * <p>Angles up to 800,000 radians are reduced by the method of Cody and Waite (1980): pi/2 is split into parts of 33 bits, whose
 * multiples are exact, and further parts are used where two numbers nearly cancel. Larger angles are reduced by the method of Payne
 * and Hanek (1983), with enough digits of 2/pi for the largest double.
 *
 * @param quadrant the multiple of pi/2; its last two bits are the quadrant
 * @param head the remainder, between -pi/4 and pi/4 radians
 * @param tail rounding error of the head in radians
 */
record HalfPiRemainder(int quadrant, double head, double tail) {

    private static final double TWO_OVER_PI = 0.6366197723675814;

    private static final double PART_1 = 1.5707963267341256;
    private static final double REST_1 = 6.077100506506192e-11;
    private static final double PART_2 = 6.077100506303966e-11;
    private static final double REST_2 = 2.0222662487959506e-21;
    private static final double PART_3 = 2.0222662487111665e-21;
    private static final double REST_3 = 8.4784276603689e-32;

    /** Limit below which multiples of the 33-bit parts of pi/2 are exact: 2^19 pi/2. */
    private static final double LARGE = 0x1.921fcp19;

    private static final int MANY_MULTIPLES = 32;

    /** 2/pi in units of 2^-1216, enough for arguments up to 2^1024 with 192 extra bits. */
    private static final BigInteger TWO_OVER_PI_DIGITS = new BigInteger(
            "a2f9836e4e441529fc2757d1f534ddc0db6295993c439041fe5163abdebbc561b7246e3a424dd2e006492eea09d1921cfe1deb1c"
                    + "b129a73ee88235f52ebb4484e99c7026b45f7e413991d639835339f49c845f8bbdf9283b1ff897ffde05980fef2f118b5a0a"
                    + "6d1f6d367ecf27cb09b74f463f669e5fea2d7527bac7ebe5f17b3d0739f78a5292ea6bfb5fb11f8d5d0856033046fc7b6bab",
            16);

    private static final int DIGITS = 1216;

    /** pi/2 in units of 2^-192. */
    private static final BigInteger HALF_PI_DIGITS =
            new BigInteger("1921fb54442d18469898cc51701b839a252049c1114cf98e8", 16);

    private static final int FRACTION = 192;
    private static final int DOUBLE_BITS = 53;

    /**
     * Reduces a non-negative angle. The record is created at a single point in the code so that escape analysis can
     * avoid the allocation.
     */
    static HalfPiRemainder of(double radians) {
        if (radians < LARGE) {
            return ofMedium(radians);
        }
        return radians <= Double.MAX_VALUE ? ofLarge(radians) : new HalfPiRemainder(0, Double.NaN, 0);
    }

    private static HalfPiRemainder ofMedium(double x) {
        int multiple = (int) (x * TWO_OVER_PI + 0.5);
        double n = multiple;
        double rest = x - n * PART_1;
        double lost = n * REST_1;
        if (!isApart(x, multiple) && bitsLost(x, rest - lost) > 16) {
            double firstRest = rest;
            rest = firstRest - n * PART_2;
            lost = n * REST_2 - ((firstRest - rest) - n * PART_2);
            if (bitsLost(x, rest - lost) > 49) {
                double secondRest = rest;
                rest = secondRest - n * PART_3;
                lost = n * REST_3 - ((secondRest - rest) - n * PART_3);
            }
        }
        double head = rest - lost;
        return new HalfPiRemainder(multiple, head, (rest - head) - lost);
    }

    private static boolean isApart(double x, int multiple) {
        return multiple < MANY_MULTIPLES && Words.high(x) != Words.high(multiple * (Math.PI / 2));
    }

    private static int bitsLost(double before, double after) {
        return exponent(before) - exponent(after);
    }

    private static int exponent(double x) {
        return (Words.high(x) >> 20) & 0x7ff;
    }

    private static HalfPiRemainder ofLarge(double x) {
        long bits = Double.doubleToRawLongBits(x);
        BigInteger fraction = BigInteger.valueOf((bits & 0xF_FFFF_FFFF_FFFFL) | 0x10_0000_0000_0000L);
        int unit = exponent(x) - 1075;
        BigInteger quotient = fraction.multiply(TWO_OVER_PI_DIGITS).shiftRight(DIGITS - FRACTION - unit);
        BigInteger multiple =
                quotient.add(BigInteger.ONE.shiftLeft(FRACTION - 1)).shiftRight(FRACTION);
        BigInteger rest = quotient.subtract(multiple.shiftLeft(FRACTION)).multiply(HALF_PI_DIGITS);
        int quadrant = multiple.intValue() & 3;
        return rest.signum() < 0 ? split(quadrant, rest.negate()).withRestNegated() : split(quadrant, rest);
    }

    private HalfPiRemainder withRestNegated() {
        return new HalfPiRemainder(quadrant, -head, -tail);
    }

    /** Splits a positive number in units of 2^-384 into a sum of two doubles. */
    private static HalfPiRemainder split(int quadrant, BigInteger number) {
        int below = number.bitLength() - DOUBLE_BITS;
        BigInteger first = number.shiftRight(below);
        BigInteger second = number.subtract(first.shiftLeft(below)).shiftRight(below - DOUBLE_BITS);
        double high = first.longValue() * Words.powerOfTwo(below - 2 * FRACTION);
        double low = second.longValue() * Words.powerOfTwo(below - DOUBLE_BITS - 2 * FRACTION);
        double head = high + low;
        return new HalfPiRemainder(quadrant, head, low - (head - high));
    }
}
