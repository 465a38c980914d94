package org.robonewbie.web;

import java.util.Objects;
import org.jspecify.annotations.Nullable;
import org.robonewbie.nao.math.PortableMath;
import org.robonewbie.pagejvm.SpecialCalls;

/** Replacements for library methods that students' programs call. */
final class PageCalls {

    private PageCalls() {}

    /**
     * Executes a static call.
     *
     * @param owner internal name of the class, such as {@code java/lang/Math}
     * @param name name of the method
     * @param arguments its arguments
     * @return its result, or {@link SpecialCalls#UNKNOWN} if the method is not replaced
     */
    static @Nullable Object call(String owner, String name, @Nullable Object[] arguments) {
        return switch (owner) {
            case "java/lang/System" -> PageSystem.call(name, arguments);
            case "java/lang/Math", "java/lang/StrictMath" -> mathematics(name, arguments);
            case "java/util/Arrays" -> NumberArrays.arrays(name, arguments);
            case "org/robonewbie/agent/walk/WalkStyle" -> NumberArrays.walkStyle(name, arguments);
            case "org/robonewbie/team/tactics/Assignment" -> NumberArrays.assignment(name, arguments);
            default -> SpecialCalls.UNKNOWN;
        };
    }

    private static Object mathematics(String name, @Nullable Object[] arguments) {
        if (arguments.length > 0 && arguments[0] instanceof Double x) {
            return mathematics(name, x, arguments.length > 1 ? arguments[1] : null);
        }
        return name.equals("round") && arguments[0] instanceof Float x ? round(x) : SpecialCalls.UNKNOWN;
    }

    private static int round(float x) {
        return (int) Math.max(Integer.MIN_VALUE, Math.min(Integer.MAX_VALUE, PortableMath.round(x)));
    }

    /**
     * Calls portable implementations: the results of mathematical functions differ between browsers, and TeaVM calculates some less exactly
     * than the JVM.
     */
    private static Object mathematics(String name, double x, @Nullable Object second) {
        return switch (name) {
            case "sin" -> PortableMath.sin(x);
            case "cos" -> PortableMath.cos(x);
            case "tan" -> PortableMath.tan(x);
            case "asin" -> PortableMath.asin(x);
            case "acos" -> PortableMath.acos(x);
            case "atan" -> PortableMath.atan(x);
            case "exp" -> PortableMath.exp(x);
            case "log" -> PortableMath.log(x);
            case "log10" -> PortableMath.log10(x);
            case "expm1" -> PortableMath.expm1(x);
            case "log1p" -> PortableMath.log1p(x);
            case "sinh" -> PortableMath.sinh(x);
            case "cosh" -> PortableMath.cosh(x);
            case "tanh" -> PortableMath.tanh(x);
            case "cbrt" -> PortableMath.cbrt(x);
            case "toRadians" -> PortableMath.toRadians(x);
            case "toDegrees" -> PortableMath.toDegrees(x);
            case "rint" -> PortableMath.rint(x);
            case "round" -> PortableMath.round(x);
            case "sqrt" -> Math.sqrt(x);
            case "floor" -> Math.floor(x);
            case "ceil" -> Math.ceil(x);
            case "atan2" -> PortableMath.atan2(x, number(second));
            case "pow" -> PortableMath.pow(x, number(second));
            case "hypot" -> PortableMath.hypot(x, number(second));
            case "IEEEremainder" -> PortableMath.IEEEremainder(x, number(second));
            default -> SpecialCalls.UNKNOWN;
        };
    }

    private static double number(@Nullable Object value) {
        return (Double) Objects.requireNonNull(value);
    }
}
