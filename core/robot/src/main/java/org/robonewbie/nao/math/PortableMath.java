package org.robonewbie.nao.math;

/**
 * Portable versions of those functions of {@link Math} whose results may differ in the last bit between platforms.
 *
 * <p>A walking robot amplifies a difference in the last bit of a sine into a different step within seconds.
 * {@link Math#sin} and similar functions may be off by one unit in the last place, depending on the JVM, processor and
 * browser, and compilers to WebAssembly replace others ({@code rint}, {@code round}, {@code IEEEremainder},
 * {@code toRadians}) with simpler formulas. All code that affects the simulated world therefore calls this class:
 *
 * <pre>{@code
 * double side = PortableMath.sin(PortableMath.toRadians(30)) * length;
 * }</pre>
 *
 * <p>It uses only operations that IEEE 754 rounds correctly: {@code + - * /}, the square root, comparisons and bit
 * patterns. {@link Math#sqrt}, {@code abs}, {@code min}, {@code max}, {@code floor}, {@code ceil}, {@code signum} and
 * {@code copySign} are exact on every platform and can be called directly. Algorithms and coefficients are those of
 * fdlibm (Sun Microsystems, 1993), on which {@link StrictMath} is also based: the results equal those of
 * {@code StrictMath} bit for bit in all tests, and are always within one unit in the last place. Special cases are
 * handled as in {@code Math}.
 */
public final class PortableMath {

    private static final double RADIANS_PER_DEGREE = 0.017453292519943295;
    private static final double DEGREES_PER_RADIAN = 57.29577951308232;

    private PortableMath() {}

    /**
     * {@return the sine of an angle}
     *
     * @param radians the angle
     */
    public static double sin(double radians) {
        return Trigonometry.sin(radians);
    }

    /**
     * {@return the cosine of an angle}
     *
     * @param radians the angle
     */
    public static double cos(double radians) {
        return Trigonometry.cos(radians);
    }

    /**
     * {@return the tangent of an angle}
     *
     * @param radians the angle
     */
    public static double tan(double radians) {
        return Trigonometry.tan(radians);
    }

    /**
     * {@return the angle in radians between -pi/2 and pi/2 that has a given sine, NaN if there is none}
     *
     * @param sine the sine, -1 to 1
     */
    public static double asin(double sine) {
        return ArcFunctions.asin(sine);
    }

    /**
     * {@return the angle in radians between 0 and pi that has a given cosine, NaN if there is none}
     *
     * @param cosine the cosine, -1 to 1
     */
    public static double acos(double cosine) {
        return ArcFunctions.acos(cosine);
    }

    /**
     * {@return the angle in radians between -pi/2 and pi/2 that has a given tangent}
     *
     * @param tangent the tangent
     */
    public static double atan(double tangent) {
        return ArcFunctions.atan(tangent);
    }

    /**
     * {@return the polar angle of a point in radians between -pi and pi, from the x axis towards the y axis}
     *
     * @param y second coordinate of the point
     * @param x first coordinate of the point
     */
    public static double atan2(double y, double x) {
        return ArcFunctions.atan2(y, x);
    }

    /**
     * {@return e to the power of x}
     *
     * @param x the exponent
     */
    public static double exp(double x) {
        return Exponential.exp(x);
    }

    /**
     * {@return the natural logarithm, NaN for negative numbers}
     *
     * @param x the number
     */
    public static double log(double x) {
        return Logarithm.log(x);
    }

    /**
     * {@return the base-10 logarithm, NaN for negative numbers}
     *
     * @param x the number
     */
    public static double log10(double x) {
        return Logarithm.log10(x);
    }

    /**
     * {@return e to the power of x, minus 1, exact near 0}
     *
     * @param x the exponent
     */
    public static double expm1(double x) {
        return ExponentialMinus1.expm1(x);
    }

    /**
     * {@return the natural logarithm of 1 + x, exact near 0; NaN below -1}
     *
     * @param x the number
     */
    public static double log1p(double x) {
        return Logarithm1p.log1p(x);
    }

    /**
     * {@return the hyperbolic sine}
     *
     * @param x the number
     */
    public static double sinh(double x) {
        return Hyperbolic.sinh(x);
    }

    /**
     * {@return the hyperbolic cosine}
     *
     * @param x the number
     */
    public static double cosh(double x) {
        return Hyperbolic.cosh(x);
    }

    /**
     * {@return the hyperbolic tangent, -1 to 1}
     *
     * @param x the number
     */
    public static double tanh(double x) {
        return Hyperbolic.tanh(x);
    }

    /**
     * {@return the cube root}
     *
     * @param x the number
     */
    public static double cbrt(double x) {
        return CubeRoot.cbrt(x);
    }

    /**
     * {@return a number raised to the power of another, with the special cases of {@link Math#pow}}
     *
     * @param base the base
     * @param exponent the exponent
     */
    public static double pow(double base, double exponent) {
        return Power.pow(base, exponent);
    }

    /**
     * {@return the length of the vector (x, y), without intermediate overflow}
     *
     * @param x first component
     * @param y second component
     */
    public static double hypot(double x, double y) {
        return Hypotenuse.hypot(x, y);
    }

    /**
     * {@return an angle converted to radians}
     *
     * @param degrees the angle in degrees
     */
    public static double toRadians(double degrees) {
        return degrees * RADIANS_PER_DEGREE;
    }

    /**
     * {@return an angle converted to degrees}
     *
     * @param radians the angle in radians
     */
    public static double toDegrees(double radians) {
        return radians * DEGREES_PER_RADIAN;
    }

    /**
     * {@return the nearest integer as a double; ties round to the even integer}
     *
     * @param x the number to round
     */
    public static double rint(double x) {
        return Rounding.rint(x);
    }

    /**
     * {@return the nearest integer; ties round up; 0 for NaN}
     *
     * @param x the number to round
     */
    public static long round(double x) {
        return Rounding.round(x);
    }

    /**
     * {@return the exact value of dividend - n * divisor, where n is the integer nearest to the quotient, or the even
     * integer in a tie}
     *
     * <p>The remainder of an angle divided by 360 is the equivalent angle between -180 and 180 degrees.
     *
     * @param dividend the dividend
     * @param divisor the divisor
     */
    public static double IEEEremainder(double dividend, double divisor) {
        return Rounding.remainder(dividend, divisor);
    }

    /**
     * {@return the rounding error of a product: the exact product is {@code a * b} plus this error}
     *
     * <p>Dekker's algorithm (1971): each factor is split into halves of 26 bits, whose products are exact.
     *
     * @param a first factor, of a magnitude below 2^970
     * @param b second factor, of a magnitude below 2^970
     */
    public static double productError(double a, double b) {
        return Rounding.productError(a, b);
    }
}
