package org.robonewbie.nao.math;

/**
 * The power function, as in fdlibm (e_pow.c): x^y = 2^(y log2(x)), where log2(x) is a sum of two doubles with 70 significant bits.
 */
final class Power {

    private static final double L1 = 0.5999999999999946;
    private static final double L2 = 0.4285714285785502;
    private static final double L3 = 0.33333332981837743;
    private static final double L4 = 0.272728123808534;
    private static final double L5 = 0.23066074577556175;
    private static final double L6 = 0.20697501780033842;

    private static final double LN2 = 0.6931471805599453;
    private static final double LN2_HEAD = 0.6931471824645996;
    private static final double LN2_TAIL = -1.904654299957768e-09;

    /** 2 / (3 ln 2), which scales the series for log2(x). */
    private static final double FACTOR = 0.9617966939259756;

    private static final double FACTOR_HEAD = 0.9617967009544373;
    private static final double FACTOR_TAIL = -7.028461650952758e-09;

    private static final double ONE_OVER_LN2 = 1.4426950408889634;
    private static final double ONE_OVER_LN2_HEAD = 1.4426950216293335;
    private static final double ONE_OVER_LN2_TAIL = 1.9259629911266175e-08;

    private static final double LOG2_OF_3_HALVES_HEAD = 0.5849624872207642;
    private static final double LOG2_OF_3_HALVES_TAIL = 1.350039202129749e-08;

    /** Exponent at and above which a power overflows or underflows unless its base is very close to 1. */
    private static final double HUGE_EXPONENT = 0x1.00001p31;

    private static final double HOPELESS_EXPONENT = 0x1.00001p64;

    /** Difference between 1024 and the base-2 logarithm of the overflow threshold. */
    private static final double OVERFLOW_MARGIN = 8.008566259537294e-17;

    private Power() {}

    static double pow(double x, double y) {
        if (y == 0) {
            return 1;
        }
        if (Double.isNaN(x) || Double.isNaN(y)) {
            return Double.NaN;
        }
        if (Double.isInfinite(y)) {
            return toInfinity(Math.abs(x), y);
        }
        return isSimple(x, y) ? simple(x, y) : general(x, y);
    }

    private static double toInfinity(double magnitude, double y) {
        if (magnitude == 1) {
            return Double.NaN;
        }
        return (magnitude > 1) == (y > 0) ? Double.POSITIVE_INFINITY : 0;
    }

    private static boolean isSimple(double x, double y) {
        return Math.abs(y) == 1 || y == 2 || (y == 0.5 && x >= 0);
    }

    private static double simple(double x, double y) {
        if (y == 0.5) {
            return Math.sqrt(x + 0.0);
        }
        if (y == 2) {
            return x * x;
        }
        return y < 0 ? 1 / x : x;
    }

    private static double general(double x, double y) {
        boolean whole = Rounding.rint(y) == y;
        if (x < 0 && !whole) {
            return x == Double.NEGATIVE_INFINITY ? ofPositive(-x, y) : Double.NaN;
        }
        boolean negative = Math.copySign(1, x) < 0 && whole && isOdd(y);
        double magnitude = ofPositive(Math.abs(x), y);
        return negative ? -magnitude : magnitude;
    }

    private static boolean isOdd(double whole) {
        return Math.abs(whole) < 0x1p53 && ((long) whole & 1) == 1;
    }

    private static double ofPositive(double x, double y) {
        if (x == 0 || x == 1 || Double.isInfinite(x)) {
            return y < 0 ? 1 / x : x;
        }
        if (Math.abs(y) >= HUGE_EXPONENT && isSettledByHugeExponent(x, y)) {
            return (x > 1) == (y > 0) ? Double.POSITIVE_INFINITY : 0;
        }
        return Math.abs(y) >= HUGE_EXPONENT ? powerNear1(x, y) : powerOfNormal(x, y);
    }

    private static boolean isSettledByHugeExponent(double x, double y) {
        return Math.abs(y) >= HOPELESS_EXPONENT || x < 0x1.fffffp-1 || x >= 0x1.00001p0;
    }

    /** Calculates x^y from a series for log2(x), for x within 2^-20 of 1. */
    private static double powerNear1(double x, double y) {
        double t = x - 1;
        double w = (t * t) * (0.5 - t * (0.3333333333333333 - t * 0.25));
        double u = ONE_OVER_LN2_HEAD * t;
        double v = t * ONE_OVER_LN2_TAIL - w * ONE_OVER_LN2;
        double head = Words.head(u + v);
        return twoToThe(y, head, v - (head - u));
    }

    /** Calculates x^y from log2(x) = n + log2(b) + log2(m / b) with m between sqrt(3)/2 and sqrt(3), where b is 1 or 3/2. */
    private static double powerOfNormal(double x, double y) {
        double normal = x < Double.MIN_NORMAL ? x * 0x1p53 : x;
        int exponent = (Words.high(normal) >> 20) - 1023 - (x < Double.MIN_NORMAL ? 53 : 0);
        int fraction = Words.high(normal) & 0xfffff;
        boolean threeHalves = fraction > 0x3988e && fraction < 0xbb67a;
        boolean up = fraction >= 0xbb67a;
        double m = Words.withHigh(normal, (fraction | 0x3ff00000) - (up ? 0x100000 : 0));
        return twoToTheLogarithm(y, m, threeHalves, up ? exponent + 1 : exponent);
    }

    private static double twoToTheLogarithm(double y, double m, boolean threeHalves, double n) {
        double base = threeHalves ? 1.5 : 1;
        double u = m - base;
        double v = 1 / (m + base);
        double s = u * v;
        double sHead = Words.head(s);
        double sumHead = Words.fromHigh(((Words.high(m) >> 1) | 0x20000000) + 0x00080000 + (threeHalves ? 1 << 18 : 0));
        double sumTail = m - (sumHead - base);
        double sTail = v * ((u - sHead * sumHead) - sHead * sumTail);
        double square = s * s;
        double rest =
                square * square * (L1 + square * (L2 + square * (L3 + square * (L4 + square * (L5 + square * L6)))))
                        + sTail * (sHead + s);
        double headSquare = sHead * sHead;
        double bracketHead = Words.head(3.0 + headSquare + rest);
        double bracketTail = rest - ((bracketHead - 3.0) - headSquare);
        double product = sHead * bracketHead;
        double productRest = sTail * bracketHead + bracketTail * s;
        double pHead = Words.head(product + productRest);
        double pTail = productRest - (pHead - product);
        double zHead = FACTOR_HEAD * pHead;
        double zTail = FACTOR_TAIL * pHead + pTail * FACTOR + (threeHalves ? LOG2_OF_3_HALVES_TAIL : 0);
        double ofBase = threeHalves ? LOG2_OF_3_HALVES_HEAD : 0;
        double head = Words.head(((zHead + zTail) + ofBase) + n);
        return twoToThe(y, head, zTail - (((head - n) - ofBase) - zHead));
    }

    /** Returns 2^(y (head + tail)). */
    private static double twoToThe(double y, double head, double tail) {
        double yHead = Words.head(y);
        double low = (y - yHead) * head + y * tail;
        double high = yHead * head;
        double sum = low + high;
        if (sum > 1024 || (sum == 1024 && low + OVERFLOW_MARGIN > sum - high)) {
            return Double.POSITIVE_INFINITY;
        }
        if (sum < -1075 || (sum == -1075 && low <= sum - high)) {
            return 0;
        }
        int whole = Math.abs(sum) >= 0x1.00001p-1 ? (int) (sum + Math.copySign(0.5, sum)) : 0;
        return twoToTheRest(high - whole, low, whole);
    }

    private static double twoToTheRest(double high, double low, int whole) {
        double head = Words.head(low + high);
        double u = head * LN2_HEAD;
        double v = (low - (head - high)) * LN2 + head * LN2_TAIL;
        double z = u + v;
        double rest = v - (z - u);
        double t = Exponential.withoutBend(z);
        return Words.scale(1 - (((z * t) / (t - 2) - (rest + z * rest)) - z), whole);
    }
}
