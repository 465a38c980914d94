package org.robonewbie.nao.math;

import java.util.List;
import java.util.SplittableRandom;
import java.util.function.DoubleBinaryOperator;
import java.util.function.DoubleUnaryOperator;

/**
 * A check that {@link PortableMath} yields the same bits on this machine as on every other: a hash of 200,000 results
 * of a function, for pseudo-random arguments of all magnitudes, is compared with a stored one.
 *
 * @param function name of the function in {@link PortableMath}
 * @param expected the stored hash
 * @param actual the hash on this machine
 */
public record MathFingerprint(String function, long expected, long actual) {

    private static final int VALUES = 200_000;

    /** Multiplier of the hash: 2^64 divided by the golden ratio, an odd number. */
    private static final long MIXER = 0x9E37_79B9_7F4A_7C15L;

    private static final List<Check> CHECKS = List.of(
            check("sin", 0x56BE_7D79_69D1_345CL, PortableMath::sin),
            check("cos", 0xC7B5_3555_FBC4_8446L, PortableMath::cos),
            check("tan", 0x2515_804F_73E7_B1A3L, PortableMath::tan),
            check("asin", 0xCF76_61BC_032A_78A4L, PortableMath::asin),
            check("acos", 0xCCC5_7C3E_1B9D_14D8L, PortableMath::acos),
            check("atan", 0x5A95_3F50_BE71_4FE0L, PortableMath::atan),
            check("exp", 0xE8DE_48CB_A8FE_AD47L, PortableMath::exp),
            check("log", 0x3577_6561_132B_AA63L, PortableMath::log),
            check("log10", 0x2E12_A8E1_610A_9F87L, PortableMath::log10),
            check("expm1", 0x16F7_F31F_945F_E554L, PortableMath::expm1),
            check("log1p", 0x1915_E05D_7470_0778L, PortableMath::log1p),
            check("sinh", 0xA795_BA87_B44F_A0AAL, PortableMath::sinh),
            check("cosh", 0x12A2_ABC7_7448_8E73L, PortableMath::cosh),
            check("tanh", 0x8EF6_743A_B8BD_EC20L, PortableMath::tanh),
            check("cbrt", 0x5EBA_F6ED_D934_3F27L, PortableMath::cbrt),
            check("toRadians", 0x52E3_3D4A_ABF9_88FEL, PortableMath::toRadians),
            check("toDegrees", 0x59CD_8863_14C1_A40FL, PortableMath::toDegrees),
            check("rint", 0x9D77_B3BA_2DB3_B7A4L, PortableMath::rint),
            check("round", 0xE385_773A_461C_6246L, PortableMath::round),
            new Check("atan2", 0x2785_8F2F_B695_583BL, PortableMath::atan2),
            new Check("pow", 0xE8D7_66FC_6A70_1712L, PortableMath::pow),
            new Check("hypot", 0x68C8_D7FF_197D_B03AL, PortableMath::hypot),
            new Check("IEEEremainder", 0xCE9C_E50C_E1DE_B5B8L, PortableMath::IEEEremainder),
            new Check("productError", 0xDB00_8951_DFEF_B89BL, PortableMath::productError));

    private record Check(String function, long expected, DoubleBinaryOperator operation) {}

    private static Check check(String function, long expected, DoubleUnaryOperator operation) {
        return new Check(function, expected, (first, second) -> operation.applyAsDouble(first));
    }

    /** {@return the fingerprints of all functions, calculated in a fraction of a second} */
    public static List<MathFingerprint> all() {
        return CHECKS.stream()
                .map(check -> new MathFingerprint(check.function(), check.expected(), of(check.operation())))
                .toList();
    }

    /** {@return whether the hashes are equal} */
    public boolean matches() {
        return expected == actual;
    }

    static long of(DoubleBinaryOperator operation) {
        SplittableRandom random = new SplittableRandom(1);
        long sum = 0;
        for (int i = 0; i < VALUES; i++) {
            double result = operation.applyAsDouble(argument(random, i), argument(random, i / 4));
            sum = MIXER * (sum ^ Double.doubleToLongBits(result)) + Long.rotateLeft(sum, 29);
        }
        return sum;
    }

    /**
     * Returns a double with random bits for kind 0, a number from -1 to 1 for kind 1, from -10 to 10 for kind 2, and of
     * moderate magnitude for kind 3; higher kinds repeat these four.
     */
    static double argument(SplittableRandom random, int kind) {
        double between = 2 * random.nextDouble() - 1;
        return switch (kind & 3) {
            case 0 -> Double.longBitsToDouble(random.nextLong());
            case 1 -> between;
            case 2 -> 10 * between;
            default -> between * Words.powerOfTwo(random.nextInt(41) - 20);
        };
    }
}
