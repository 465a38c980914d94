package org.robonewbie.nao.math;

/** The length of a vector in the plane, as in fdlibm (e_hypot.c): the sum of squares is calculated in two parts. */
final class Hypotenuse {

    private static final int NEGLIGIBLE_EXPONENTS = 60;

    private Hypotenuse() {}

    static double hypot(double x, double y) {
        double longer = Math.max(Math.abs(x), Math.abs(y));
        double shorter = Math.min(Math.abs(x), Math.abs(y));
        if (!(longer <= Double.MAX_VALUE)) {
            return Double.isInfinite(x) || Double.isInfinite(y) ? Double.POSITIVE_INFINITY : Double.NaN;
        }
        if (Words.high(longer) - Words.high(shorter) > NEGLIGIBLE_EXPONENTS << 20) {
            return longer + shorter;
        }
        return scaled(longer, shorter);
    }

    /** Scales the components so that their squares neither overflow nor become subnormal. */
    private static double scaled(double longer, double shorter) {
        if (longer >= 0x1.00001p500) {
            return 0x1p600 * rootOfSquares(longer * 0x1p-600, shorter * 0x1p-600);
        }
        if (shorter >= 0x1p-500) {
            return rootOfSquares(longer, shorter);
        }
        if (shorter >= Double.MIN_NORMAL) {
            return 0x1p-600 * rootOfSquares(longer * 0x1p600, shorter * 0x1p600);
        }
        return shorter == 0 ? longer : 0x1p-1022 * rootOfSquares(longer * 0x1p1022, shorter * 0x1p1022);
    }

    private static double rootOfSquares(double longer, double shorter) {
        double difference = longer - shorter;
        double head;
        if (difference > shorter) {
            head = Words.head(longer);
            return Math.sqrt(head * head - (shorter * -shorter - (longer - head) * (longer + head)));
        }
        double twice = longer + longer;
        head = Words.head(twice);
        double shorterHead = Words.head(shorter);
        double mixed = head * (shorter - shorterHead) + (twice - head) * shorter;
        return Math.sqrt(head * shorterHead - (difference * -difference - mixed));
    }
}
