package org.robonewbie.web;

import static org.assertj.core.api.Assertions.assertThat;

import java.lang.reflect.Method;
import java.lang.reflect.Modifier;
import java.util.Arrays;
import java.util.List;
import java.util.Set;
import java.util.stream.Stream;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/** Mathematical functions in the page equal those of {@link StrictMath}, and none is left to the compiler to WebAssembly. */
class PageCallsTest {

    /** Functions that IEEE 754 prescribes, and {@code fma}, which the page lacks. */
    private static final Set<String> EXACT = Set.of(
            "abs",
            "clamp",
            "copySign",
            "fma",
            "getExponent",
            "max",
            "min",
            "nextAfter",
            "nextDown",
            "nextUp",
            "scalb",
            "signum",
            "ulp");

    private static final List<Double> NUMBERS =
            List.of(0.0, -0.0, 0.3, -0.7, 1.5, -2.5, 12.34, -1000.0, 1e10, -1e19, 1e300, Double.NaN);

    static Stream<Method> functions() {
        return Arrays.stream(StrictMath.class.getMethods())
                .filter(method -> Modifier.isStatic(method.getModifiers()) && !EXACT.contains(method.getName()))
                .filter(method -> isReal(method.getParameterTypes()));
    }

    private static boolean isReal(Class<?>[] parameters) {
        return parameters.length > 0 && (parameters[0] == double.class || parameters[0] == float.class);
    }

    @ParameterizedTest
    @MethodSource("functions")
    void functionEqualsThatOfTheJvm(Method function) throws ReflectiveOperationException {
        for (double first : NUMBERS) {
            for (double second : NUMBERS) {
                Object[] arguments = Arrays.stream(function.getParameterTypes())
                        .map(type -> type == float.class ? (Object) (float) first : (Object) first)
                        .toArray();
                if (arguments.length == 2) {
                    arguments[1] = second;
                }

                assertThat(PageCalls.call("java/lang/Math", function.getName(), arguments))
                        .as("%s of %s", function.getName(), Arrays.toString(arguments))
                        .isEqualTo(function.invoke(null, arguments));
            }
        }
    }
}
