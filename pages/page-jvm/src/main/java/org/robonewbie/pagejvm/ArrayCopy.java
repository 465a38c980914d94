package org.robonewbie.pagejvm;

import java.lang.reflect.Array;
import org.jspecify.annotations.Nullable;

/** Copies and recognises arrays of any type: TeaVM 0.15.0 fails at those of numbers where it does not know the type before. */
public final class ArrayCopy {

    private ArrayCopy() {}

    /**
     * Copies as {@link System#arraycopy} does.
     *
     * @param from an array
     * @param at index of the first copied value
     * @param to an array of the same type, or the same array
     * @param place index of the first value that is replaced
     * @param count how many values are copied
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

    /** {@return whether a type, written as in class files, is an array of numbers, or an array of such arrays} */
    static boolean isOfNumbers(String type) {
        return !type.endsWith(";");
    }

    /** {@return whether a value is an array of numbers of a type that is written as in class files} */
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
