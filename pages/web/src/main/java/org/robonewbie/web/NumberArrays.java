package org.robonewbie.web;

import java.util.Arrays;
import java.util.Objects;
import org.jspecify.annotations.Nullable;
import org.robonewbie.agent.walk.WalkStyle;
import org.robonewbie.agent.walk.WalkVelocity;
import org.robonewbie.pagejvm.SpecialCalls;
import org.robonewbie.team.tactics.Assignment;

/**
 * Directly calls methods that take primitive arrays, because the compiled module cannot call them by reflection.
 */
final class NumberArrays {

    /** Result of a void method. */
    private static final int NOTHING = 0;

    private NumberArrays() {}

    /**
     * Calls a method of {@link WalkStyle}.
     *
     * @param name name of the method
     * @param given its arguments
     * @return its result, or {@link SpecialCalls#UNKNOWN}
     */
    static Object walkStyle(String name, @Nullable Object[] given) {
        return name.equals("of")
                ? WalkStyle.of(
                        toInt(given[0]),
                        (WalkVelocity) Objects.requireNonNull(given[1]),
                        (WalkVelocity) Objects.requireNonNull(given[2]),
                        (double[]) Objects.requireNonNull(given[3]))
                : SpecialCalls.UNKNOWN;
    }

    /**
     * Calls a method of {@link Assignment}.
     *
     * @param name name of the method
     * @param given its arguments
     * @return its result, or {@link SpecialCalls#UNKNOWN}
     */
    static Object assignment(String name, @Nullable Object[] given) {
        return name.equals("cheapest")
                ? Assignment.cheapest(rows((Object[]) Objects.requireNonNull(given[0])))
                : SpecialCalls.UNKNOWN;
    }

    private static double[][] rows(Object[] given) {
        double[][] rows = new double[given.length][];
        for (int i = 0; i < given.length; i++) {
            rows[i] = (double[]) given[i];
        }
        return rows;
    }

    /**
     * Calls a method of {@link Arrays}.
     *
     * @param name name of the method
     * @param given its arguments
     * @return its result, or {@link SpecialCalls#UNKNOWN}
     */
    static Object arrays(String name, @Nullable Object[] given) {
        if (given[0] instanceof double[] numbers) {
            return ofDoubles(name, numbers, given);
        }
        return given[0] instanceof int[] numbers ? ofInts(name, numbers, given) : SpecialCalls.UNKNOWN;
    }

    private static Object ofDoubles(String name, double[] numbers, @Nullable Object[] given) {
        return switch (name + given.length) {
            case "toString1" -> Arrays.toString(numbers);
            case "stream1" -> Arrays.stream(numbers);
            case "copyOf2" -> Arrays.copyOf(numbers, toInt(given[1]));
            case "copyOfRange3" -> Arrays.copyOfRange(numbers, toInt(given[1]), toInt(given[2]));
            case "equals2" -> Arrays.equals(numbers, (double[]) given[1]) ? 1 : 0;
            case "fill2" -> {
                Arrays.fill(numbers, (Double) Objects.requireNonNull(given[1]));
                yield NOTHING;
            }
            case "sort1" -> {
                Arrays.sort(numbers);
                yield NOTHING;
            }
            default -> SpecialCalls.UNKNOWN;
        };
    }

    private static Object ofInts(String name, int[] numbers, @Nullable Object[] given) {
        return switch (name + given.length) {
            case "toString1" -> Arrays.toString(numbers);
            case "stream1" -> Arrays.stream(numbers);
            case "copyOf2" -> Arrays.copyOf(numbers, toInt(given[1]));
            case "copyOfRange3" -> Arrays.copyOfRange(numbers, toInt(given[1]), toInt(given[2]));
            case "equals2" -> Arrays.equals(numbers, (int[]) given[1]) ? 1 : 0;
            case "fill2" -> {
                Arrays.fill(numbers, toInt(given[1]));
                yield NOTHING;
            }
            case "sort1" -> {
                Arrays.sort(numbers);
                yield NOTHING;
            }
            default -> SpecialCalls.UNKNOWN;
        };
    }

    private static int toInt(@Nullable Object value) {
        return (Integer) Objects.requireNonNull(value);
    }
}
