package org.robonewbie.nao.math;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Arrays;
import java.util.SplittableRandom;
import java.util.function.DoubleBinaryOperator;
import java.util.function.DoubleUnaryOperator;
import java.util.stream.DoubleStream;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;

/** Compares with {@link StrictMath}, whose results are prescribed too, on the JVM. */
class PortableMathTest {

    private static final int VALUES = 200_000;

    /** Up to here angles are reduced as in fdlibm. */
    private static final double LARGE_ANGLE = 800_000;

    private static final double[] SPECIAL = {
        0.0,
        Double.MIN_VALUE,
        0x1p-1030,
        Double.MIN_NORMAL,
        1e-300,
        0x1p-28,
        0x1p-27,
        0x1p-55,
        0x1p-54,
        0x1p-29,
        0.25,
        0.2928932188134524,
        0.34657359027997264,
        0.41421356237309503,
        0.4375,
        0.49999999999999994,
        0.5,
        0.5000000000000001,
        Math.PI / 4,
        0x1.fffffffffffffp-1,
        1.0,
        1.0000000000000002,
        1.5,
        Math.PI / 2,
        2.0,
        2.5,
        3.0,
        Math.PI,
        4.0,
        10.0,
        22.0,
        38.81624207738945,
        100.0,
        180.0,
        360.0,
        540.0,
        709.782712893384,
        710.4758600739439,
        745.1332191019411,
        746.0,
        1024.0,
        1074.0,
        1075.0,
        1e5,
        3e9,
        4503599627370495.5,
        9007199254740991.0,
        1e19,
        1e150,
        1e300,
        Double.MAX_VALUE,
        Double.POSITIVE_INFINITY,
        Double.NaN
    };

    static Stream<Arguments> functions() {
        return Stream.of(
                function("sin", PortableMath::sin, StrictMath::sin),
                function("cos", PortableMath::cos, StrictMath::cos),
                function("tan", PortableMath::tan, StrictMath::tan),
                function("asin", PortableMath::asin, StrictMath::asin),
                function("acos", PortableMath::acos, StrictMath::acos),
                function("atan", PortableMath::atan, StrictMath::atan),
                function("exp", PortableMath::exp, StrictMath::exp),
                function("log", PortableMath::log, StrictMath::log),
                function("log10", PortableMath::log10, StrictMath::log10),
                function("expm1", PortableMath::expm1, StrictMath::expm1),
                function("log1p", PortableMath::log1p, StrictMath::log1p),
                function("sinh", PortableMath::sinh, StrictMath::sinh),
                function("cosh", PortableMath::cosh, StrictMath::cosh),
                function("tanh", PortableMath::tanh, StrictMath::tanh),
                function("cbrt", PortableMath::cbrt, StrictMath::cbrt),
                function("toRadians", PortableMath::toRadians, StrictMath::toRadians),
                function("toDegrees", PortableMath::toDegrees, StrictMath::toDegrees),
                function("rint", PortableMath::rint, StrictMath::rint),
                function("round", PortableMath::round, StrictMath::round));
    }

    static Stream<Arguments> functionsOfTwo() {
        return Stream.of(
                functionOfTwo("atan2", PortableMath::atan2, StrictMath::atan2),
                functionOfTwo("pow", PortableMath::pow, StrictMath::pow),
                functionOfTwo("hypot", PortableMath::hypot, StrictMath::hypot),
                functionOfTwo("IEEEremainder", PortableMath::IEEEremainder, StrictMath::IEEEremainder));
    }

    @ParameterizedTest(name = "{0}")
    @MethodSource("functions")
    void functionEqualsStrictMath(String name, DoubleUnaryOperator portable, DoubleUnaryOperator strict) {
        SplittableRandom random = new SplittableRandom(2);

        assertThat(IntStream.range(0, VALUES)
                        .mapToDouble(i -> MathFingerprint.argument(random, i))
                        .filter(x -> differs(portable.applyAsDouble(x), strict.applyAsDouble(x)))
                        .filter(x -> !isLargeAngle(name, x)
                                || !isNextTo(portable.applyAsDouble(x), strict.applyAsDouble(x))))
                .isEmpty();
    }

    @ParameterizedTest(name = "{0}")
    @MethodSource("functions")
    void specialValueGivesWhatStrictMathGives(String name, DoubleUnaryOperator portable, DoubleUnaryOperator strict) {
        assertThat(specialValues().filter(x -> differs(portable.applyAsDouble(x), strict.applyAsDouble(x))))
                .isEmpty();
    }

    @ParameterizedTest(name = "{0}")
    @MethodSource("functionsOfTwo")
    void functionOfTwoEqualsStrictMath(String name, DoubleBinaryOperator portable, DoubleBinaryOperator strict) {
        SplittableRandom random = new SplittableRandom(3);

        assertThat(IntStream.range(0, VALUES).filter(i -> {
                    double x = MathFingerprint.argument(random, i);
                    double y = MathFingerprint.argument(random, i / 4);
                    return differs(portable.applyAsDouble(x, y), strict.applyAsDouble(x, y));
                }))
                .isEmpty();
    }

    @ParameterizedTest(name = "{0}")
    @MethodSource("functionsOfTwo")
    void pairOfSpecialValuesGivesWhatStrictMathGives(
            String name, DoubleBinaryOperator portable, DoubleBinaryOperator strict) {
        assertThat(specialValues()
                        .boxed()
                        .flatMap(x -> specialValues()
                                .filter(y -> differs(portable.applyAsDouble(x, y), strict.applyAsDouble(x, y)))
                                .mapToObj(y -> name + "(" + x + ", " + y + ")")))
                .isEmpty();
    }

    @Test
    void powersNearOneWithLargeExponentsEqualStrictMath() {
        SplittableRandom random = new SplittableRandom(4);

        assertThat(IntStream.range(0, VALUES).filter(i -> {
                    double x = 1 + 1e-6 * (random.nextDouble() - 0.5);
                    double y = 1e10 * (random.nextDouble() - 0.5);
                    return differs(PortableMath.pow(x, y), StrictMath.pow(x, y));
                }))
                .isEmpty();
    }

    @Test
    void hugeAnglesAreReducedByTheDigitsOfPi() {
        assertThat(PortableMath.sin(1e22)).isEqualTo(-0.8522008497671888);
        assertThat(PortableMath.cos(1e22)).isEqualTo(0.523214785395139);
        assertThat(PortableMath.sin(Double.MAX_VALUE)).isEqualTo(0.004961954789184062);
    }

    @Test
    void anglesNextToMultiplesOfHalfPiKeepAllDigits() {
        assertThat(IntStream.rangeClosed(-100_000, 100_000)
                        .mapToDouble(multiple -> multiple * (Math.PI / 2))
                        .filter(angle -> differs(PortableMath.tan(angle), StrictMath.tan(angle))
                                || differs(PortableMath.sin(angle), StrictMath.sin(angle))))
                .isEmpty();
    }

    @Test
    void productAndItsErrorAreTheExactProduct() {
        SplittableRandom random = new SplittableRandom(5);

        assertThat(IntStream.range(0, VALUES).filter(i -> {
                    double a = 1e8 * (random.nextDouble() - 0.5);
                    double b = 1e22 * random.nextDouble();
                    return PortableMath.productError(a, b) != Math.fma(a, b, -(a * b));
                }))
                .isEmpty();
    }

    private static Arguments function(String name, DoubleUnaryOperator portable, DoubleUnaryOperator strict) {
        return Arguments.of(name, portable, strict);
    }

    private static Arguments functionOfTwo(String name, DoubleBinaryOperator portable, DoubleBinaryOperator strict) {
        return Arguments.of(name, portable, strict);
    }

    private static DoubleStream specialValues() {
        return Arrays.stream(SPECIAL).flatMap(value -> DoubleStream.of(value, -value));
    }

    private static boolean differs(double one, double other) {
        return Double.doubleToLongBits(one) != Double.doubleToLongBits(other);
    }

    private static boolean isLargeAngle(String function, double x) {
        return Math.abs(x) > LARGE_ANGLE && "sin cos tan".contains(function);
    }

    private static boolean isNextTo(double one, double other) {
        return Math.abs(Double.doubleToLongBits(one) - Double.doubleToLongBits(other)) == 1;
    }
}
