package org.robonewbie.nao.math;

/**
 * Sine, cosine and tangent: the angle is reduced by the nearest multiple of pi/2 to at most pi/4, where a polynomial is accurate.
 * The minimax polynomials are those of fdlibm (k_sin.c, k_cos.c, k_tan.c).
 *
 * <p>The reduced angle is a sum of two doubles, {@code x + tail}, for sufficient precision.
 */
final class Trigonometry {

    /** Largest angle that needs no reduction, slightly above pi/4. */
    private static final double QUARTER_PI = 0x1.921fcp-1;

    private static final double TOO_SMALL_TO_BEND = 0x1p-27;

    private static final double S1 = -0.16666666666666632;
    private static final double S2 = 0.00833333333332249;
    private static final double S3 = -0.0001984126982985795;
    private static final double S4 = 2.7557313707070068e-06;
    private static final double S5 = -2.5050760253406863e-08;
    private static final double S6 = 1.58969099521155e-10;

    private static final double C1 = 0.0416666666666666;
    private static final double C2 = -0.001388888888887411;
    private static final double C3 = 2.480158728947673e-05;
    private static final double C4 = -2.7557314351390663e-07;
    private static final double C5 = 2.087572321298175e-09;
    private static final double C6 = -1.1359647557788195e-11;

    private static final double T0 = 0.3333333333333341;
    private static final double T1 = 0.13333333333320124;
    private static final double T2 = 0.05396825397622605;
    private static final double T3 = 0.021869488294859542;
    private static final double T4 = 0.0088632398235993;
    private static final double T5 = 0.0035920791075913124;
    private static final double T6 = 0.0014562094543252903;
    private static final double T7 = 0.0005880412408202641;
    private static final double T8 = 0.0002464631348184699;
    private static final double T9 = 7.817944429395571e-05;
    private static final double T10 = 7.140724913826082e-05;
    private static final double T11 = -1.8558637485527546e-05;
    private static final double T12 = 2.590730518636337e-05;

    /** Angle at and above which the tangent is calculated from the difference between pi/4 and the angle. */
    private static final double STEEP = 0x1.59428p-1;

    private static final double PI_QUARTER_HEAD = 0.7853981633974483;
    private static final double PI_QUARTER_TAIL = 3.061616997868383e-17;

    private Trigonometry() {}

    static double sin(double x) {
        if (Math.abs(x) < QUARTER_PI) {
            return sinNearZero(x, 0);
        }
        HalfPiRemainder reduced = HalfPiRemainder.of(Math.abs(x));
        double sine = turned(reduced, reduced.quadrant());
        return x < 0 ? -sine : sine;
    }

    static double cos(double x) {
        if (Math.abs(x) < QUARTER_PI) {
            return cosNearZero(x, 0);
        }
        HalfPiRemainder reduced = HalfPiRemainder.of(Math.abs(x));
        return turned(reduced, reduced.quadrant() + 1);
    }

    static double tan(double x) {
        if (Math.abs(x) < QUARTER_PI) {
            return tanNearZero(x, 0, false);
        }
        HalfPiRemainder reduced = HalfPiRemainder.of(Math.abs(x));
        double tangent = tanNearZero(reduced.head(), reduced.tail(), (reduced.quadrant() & 1) == 1);
        return x < 0 ? -tangent : tangent;
    }

    /** Returns the sine of a reduced angle plus the given number of quarter turns. */
    private static double turned(HalfPiRemainder angle, int quarterTurns) {
        return switch (quarterTurns & 3) {
            case 0 -> sinNearZero(angle.head(), angle.tail());
            case 1 -> cosNearZero(angle.head(), angle.tail());
            case 2 -> -sinNearZero(angle.head(), angle.tail());
            default -> -cosNearZero(angle.head(), angle.tail());
        };
    }

    private static double sinNearZero(double x, double tail) {
        if (Math.abs(x) < TOO_SMALL_TO_BEND) {
            return x;
        }
        double square = x * x;
        double cube = square * x;
        double rest = S2 + square * (S3 + square * (S4 + square * (S5 + square * S6)));
        return tail == 0
                ? x + cube * (S1 + square * rest)
                : x - ((square * (0.5 * tail - cube * rest) - tail) - cube * S1);
    }

    private static double cosNearZero(double x, double tail) {
        double magnitude = Math.abs(x);
        if (magnitude < TOO_SMALL_TO_BEND) {
            return 1;
        }
        double square = x * x;
        double rest = square * (C1 + square * (C2 + square * (C3 + square * (C4 + square * (C5 + square * C6)))));
        double bend = square * rest - x * tail;
        if (magnitude < 0x1.33333p-2) {
            return 1 - (0.5 * square - bend);
        }
        // About a quarter of the angle is subtracted from both 1 and the square, which reduces the cancellation error.
        double share = magnitude < 0x1.90001p-1 ? 0.25 * Words.head(magnitude) : 0.28125;
        return (1 - share) - ((0.5 * square - share) - bend);
    }

    private static double tanNearZero(double x, double tail, boolean inverse) {
        double magnitude = Math.abs(x);
        if (magnitude < 0x1p-28 && !inverse) {
            return x;
        }
        return magnitude < STEEP ? flatTan(x, tail, inverse) : steepTan(x, tail, inverse);
    }

    private static double flatTan(double x, double tail, boolean inverse) {
        double bend = Math.abs(x) < 0x1p-28 ? tail : tanBend(x, tail);
        double tangent = x + bend;
        return inverse ? minusInverse(tangent, x, bend) : tangent;
    }

    private static double steepTan(double x, double tail, boolean inverse) {
        double sign = x < 0 ? -1 : 1;
        double missing = (PI_QUARTER_HEAD - sign * x) + (PI_QUARTER_TAIL - sign * tail);
        double bend = tanBend(missing, 0);
        double tangent = missing + bend;
        double one = inverse ? -1 : 1;
        return sign * (one - 2.0 * (missing - (tangent * tangent / (tangent + one) - bend)));
    }

    /** Returns tan(x + tail) - x. */
    private static double tanBend(double x, double tail) {
        double square = x * x;
        double fourth = square * square;
        double odd = T1 + fourth * (T3 + fourth * (T5 + fourth * (T7 + fourth * (T9 + fourth * T11))));
        double even = square * (T2 + fourth * (T4 + fourth * (T6 + fourth * (T8 + fourth * (T10 + fourth * T12)))));
        double cube = square * x;
        return (tail + square * (cube * (odd + even) + tail)) + T0 * cube;
    }

    /** Returns -1 / (x + bend), more precisely than a division: the error of its leading part is corrected. */
    private static double minusInverse(double sum, double x, double bend) {
        double head = Words.head(sum);
        double rest = bend - (head - x);
        double quotient = -1.0 / sum;
        double quotientHead = Words.head(quotient);
        return quotientHead + quotient * ((1.0 + quotientHead * head) + quotientHead * rest);
    }
}
