package org.robonewbie.nao.math;

/** The inverse functions of sine, cosine and tangent, as in fdlibm (e_asin.c, e_acos.c, s_atan.c, e_atan2.c). */
final class ArcFunctions {

    private static final double HALF_PI = Math.PI / 2;
    private static final double HALF_PI_TAIL = 6.123233995736766e-17;
    private static final double PI_TAIL = 1.2246467991473532e-16;

    private static final double P0 = 0.16666666666666666;
    private static final double P1 = -0.3255658186224009;
    private static final double P2 = 0.20121253213486293;
    private static final double P3 = -0.04005553450067941;
    private static final double P4 = 0.0007915349942898145;
    private static final double P5 = 3.479331075960212e-05;
    private static final double Q1 = -2.403394911734414;
    private static final double Q2 = 2.0209457602335057;
    private static final double Q3 = -0.6882839716054533;
    private static final double Q4 = 0.07703815055590194;

    private static final double A0 = 0.3333333333333293;
    private static final double A1 = -0.19999999999876483;
    private static final double A2 = 0.14285714272503466;
    private static final double A3 = -0.11111110405462356;
    private static final double A4 = 0.09090887133436507;
    private static final double A5 = -0.0769187620504483;
    private static final double A6 = 0.06661073137387531;
    private static final double A7 = -0.058335701337905735;
    private static final double A8 = 0.049768779946159324;
    private static final double A9 = -0.036531572744216916;
    private static final double A10 = 0.016285820115365782;

    private ArcFunctions() {}

    static double asin(double x) {
        double magnitude = Math.abs(x);
        if (magnitude < 0.5) {
            return magnitude < 0x1p-27 ? x : x + x * asinBend(x * x);
        }
        return Math.copySign(asinAboveHalf(magnitude), x);
    }

    private static double asinAboveHalf(double x) {
        double square = (1 - x) * 0.5;
        double bend = asinBend(square);
        double root = Math.sqrt(square);
        if (x >= 0x1.f3333p-1) {
            return HALF_PI - (2.0 * (root + root * bend) - HALF_PI_TAIL);
        }
        double head = Words.head(root);
        double rest = (square - head * head) / (root + head);
        return HALF_PI / 2 - ((2.0 * root * bend - (HALF_PI_TAIL - 2.0 * rest)) - (HALF_PI / 2 - 2.0 * head));
    }

    static double acos(double x) {
        if (Math.abs(x) < 0.5) {
            return Math.abs(x) < 0x1.00001p-57
                    ? HALF_PI + HALF_PI_TAIL
                    : HALF_PI - (x - (HALF_PI_TAIL - x * asinBend(x * x)));
        }
        if (x < 0) {
            double square = (1 + x) * 0.5;
            double root = Math.sqrt(square);
            return Math.PI - 2.0 * (root + (asinBend(square) * root - HALF_PI_TAIL));
        }
        return x == 1 ? 0 : acosAboveHalf(x);
    }

    private static double acosAboveHalf(double x) {
        double square = (1 - x) * 0.5;
        double root = Math.sqrt(square);
        double head = Words.head(root);
        double rest = (square - head * head) / (root + head);
        return 2.0 * (head + (asinBend(square) * root + rest));
    }

    /** Returns (asin(x) - x) / x, given the square of x. */
    private static double asinBend(double square) {
        double p = square * (P0 + square * (P1 + square * (P2 + square * (P3 + square * (P4 + square * P5)))));
        double q = 1 + square * (Q1 + square * (Q2 + square * (Q3 + square * Q4)));
        return p / q;
    }

    static double atan(double x) {
        double magnitude = Math.abs(x);
        if (magnitude < 0.4375) {
            return magnitude < 0x1p-29 ? x : x - x * atanBend(x);
        }
        return magnitude < 0x1p66 ? Math.copySign(atanAboveZero(magnitude), x) : atanFarAway(x);
    }

    private static double atanFarAway(double x) {
        return Double.isNaN(x) ? x : Math.copySign(HALF_PI + HALF_PI_TAIL, x);
    }

    /**
     * Returns atan(x) as the sum of a small angle and the nearest of four reference angles, whose tangents are 0.5, 1, 1.5 and
     * infinity.
     */
    private static double atanAboveZero(double x) {
        if (x < 0.6875) {
            return atanBeside(0.4636476090008061, 2.2698777452961687e-17, (2.0 * x - 1) / (2.0 + x));
        }
        if (x < 1.1875) {
            return atanBeside(HALF_PI / 2, 3.061616997868383e-17, (x - 1) / (x + 1));
        }
        if (x < 2.4375) {
            return atanBeside(0.982793723247329, 1.3903311031230998e-17, (x - 1.5) / (1 + 1.5 * x));
        }
        return atanBeside(HALF_PI, HALF_PI_TAIL, -1.0 / x);
    }

    private static double atanBeside(double angle, double angleTail, double x) {
        return angle - ((x * atanBend(x) - angleTail) - x);
    }

    /** Returns (x - atan(x)) / x. */
    private static double atanBend(double x) {
        double square = x * x;
        double fourth = square * square;
        double odd = square * (A0 + fourth * (A2 + fourth * (A4 + fourth * (A6 + fourth * (A8 + fourth * A10)))));
        double even = fourth * (A1 + fourth * (A3 + fourth * (A5 + fourth * (A7 + fourth * A9))));
        return odd + even;
    }

    static double atan2(double y, double x) {
        if (Double.isNaN(x) || Double.isNaN(y)) {
            return Double.NaN;
        }
        if (isOnAxis(y, x)) {
            return Math.copySign(HALF_PI, y);
        }
        double angle = angleFromAxis(Math.abs(y), Math.abs(x));
        boolean backwards = Math.copySign(1, x) < 0;
        return Math.copySign(backwards ? Math.PI - (angle - PI_TAIL) : angle, y);
    }

    private static boolean isOnAxis(double y, double x) {
        return x == 0 ? y != 0 : Double.isInfinite(y) && !Double.isInfinite(x);
    }

    /** Returns the angle between the x axis and a point in the first quadrant. */
    private static double angleFromAxis(double y, double x) {
        if (y == 0) {
            return 0;
        }
        return Double.isInfinite(y) && Double.isInfinite(x) ? HALF_PI / 2 : atan(y / x);
    }
}
