package org.robonewbie.pagejvm;

import java.lang.reflect.Array;
import org.jspecify.annotations.Nullable;

/**
 * Copies arrays and checks their types, which TeaVM 0.15.0 does incorrectly for primitive arrays whose type is not
 * known statically.
 */
public final class ArrayCopy {

    private ArrayCopy() {}

    /**
     * Copies elements like {@link System#arraycopy}.
     *
     * @param from the source array
     * @param at index of the first copied value
     * @param to the destination array, of the same type
     * @param place index of the first replaced value
     * @param count number of values
     * @throws ArrayIndexOutOfBoundsException if one of the arrays is too short
     */
    public static void copy(Object from, int at, Object to, int place, int count) {
        if (at < 0 || place < 0 || count < 0 || at > length(from) - count || place > length(to) - count) {
            throw new ArrayIndexOutOfBoundsException("arraycopy: " + count + " values from index " + at + " of "
                    + length(from) + " to index " + place + " of " + length(to));
        }
        boolean backwards = from == to && at < place;
        for (int i = 0; i < count; i++) {
            int next = backwards ? count - 1 - i : i;
            ArrayInstructions.write(to, place + next, ArrayInstructions.read(from, at + next));
        }
    }

    /** {@return whether an array descriptor denotes an array of primitives, possibly nested} */
    static boolean isOfNumbers(String type) {
        return !type.endsWith(";");
    }

    /** {@return whether a value is a primitive array of the type that a descriptor denotes} */
    static boolean isArray(@Nullable Object value, String type) {
        return switch (type) {
            case "[D" -> value instanceof double[];
            case "[I" -> value instanceof int[];
            case "[Z" -> value instanceof boolean[];
            case "[C" -> value instanceof char[];
            case "[B" -> value instanceof byte[];
            case "[S" -> value instanceof short[];
            case "[J" -> value instanceof long[];
            case "[F" -> value instanceof float[];
            default -> value instanceof Object[] rows && areArrays(rows, type.substring(1));
        };
    }

    private static boolean areArrays(@Nullable Object[] rows, String type) {
        for (Object row : rows) {
            if (row != null && !isArray(row, type)) {
                return false;
            }
        }
        return true;
    }

    private static int length(Object array) {
        return Array.getLength(array);
    }
}
