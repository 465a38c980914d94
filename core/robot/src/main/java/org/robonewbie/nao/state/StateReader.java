package org.robonewbie.nao.state;

import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.Supplier;
import org.robonewbie.nao.Vector3;

/**
 * Deserializes the output of a {@link StateWriter}, in the same order. Invalid data causes an {@link
 * IllegalArgumentException} whose message contains the offset.
 */
public final class StateReader {

    private final byte[] bytes;
    private final int end;
    private int next;

    /**
     * Creates a reader that starts at the first byte.
     *
     * @param bytes the result of {@link StateWriter#toBytes()}; must not change while it is read
     */
    public StateReader(byte[] bytes) {
        this(bytes, 0);
    }

    /**
     * Creates a reader that starts at an offset.
     *
     * @param bytes the bytes; must not change while they are read
     * @param start index of the first byte to read
     */
    public StateReader(byte[] bytes, int start) {
        this.bytes = bytes;
        this.end = bytes.length;
        this.next = start;
    }

    /** {@return the next boolean} */
    public boolean getBoolean() {
        need(1);
        byte value = bytes[next++];
        if (value != 0 && value != 1) {
            throw damaged("has " + value + " where yes (1) or no (0) is expected", next - 1);
        }
        return value == 1;
    }

    /** {@return the next integer} */
    public int getInt() {
        need(Integer.BYTES);
        int value = 0;
        for (int shift = 0; shift < Integer.SIZE; shift += Byte.SIZE) {
            value |= (bytes[next++] & 0xFF) << shift;
        }
        return value;
    }

    /** {@return the next long integer} */
    public long getLong() {
        need(Long.BYTES);
        long value = 0;
        for (int shift = 0; shift < Long.SIZE; shift += Byte.SIZE) {
            value |= (bytes[next++] & 0xFFL) << shift;
        }
        return value;
    }

    /** {@return the next double, bit for bit as it was written} */
    public double getDouble() {
        return Double.longBitsToDouble(getLong());
    }

    /**
     * Fills an array with the next doubles.
     *
     * @param target the array to fill
     */
    public void getDoubles(double[] target) {
        for (int i = 0; i < target.length; i++) {
            target[i] = getDouble();
        }
    }

    /** {@return the next vector} */
    public Vector3 getVector() {
        double x = getDouble();
        double y = getDouble();
        return new Vector3(x, y, getDouble());
    }

    /**
     * Reads an enum constant.
     *
     * @param <E> the enum
     * @param constants all constants of the enum
     * @return the next constant
     */
    public <E extends Enum<E>> E getEnum(E[] constants) {
        return constants[getIndex(constants.length)];
    }

    /**
     * Reads an index.
     *
     * @param count number of elements
     * @return the next integer, from 0 to count - 1
     */
    public int getIndex(int count) {
        int index = getInt();
        if (index < 0 || index >= count) {
            throw damaged("has index " + index + " where only " + count + " elements exist", next - Integer.BYTES);
        }
        return index;
    }

    /** {@return the next byte array} */
    public byte[] getBytes() {
        int count = getInt();
        if (count < 0 || count > end - next) {
            throw damaged("ends before the " + count + " bytes that should follow", next - Integer.BYTES);
        }
        byte[] copy = new byte[count];
        System.arraycopy(bytes, next, copy, 0, count);
        next += count;
        return copy;
    }

    /** {@return the next string} */
    public String getText() {
        return new String(getBytes(), StandardCharsets.UTF_8);
    }

    /**
     * Reads an optional value.
     *
     * @param <T> type of the value
     * @param reader reads the value; only called if there is one
     * @return the value, or empty
     */
    public <T> Optional<T> getOptional(Supplier<T> reader) {
        return getBoolean() ? Optional.of(reader.get()) : Optional.empty();
    }

    /**
     * Reads a collection.
     *
     * @param <T> type of the elements
     * @param reader reads one element, which occupies at least one byte
     * @return a new list of the elements, in the order in which they were written
     */
    public <T> List<T> getAll(Supplier<T> reader) {
        int count = getCount();
        List<T> elements = new ArrayList<>(count);
        for (int i = 0; i < count; i++) {
            elements.add(reader.get());
        }
        return elements;
    }

    /** {@return the number of elements that follow, each of which occupies at least one byte} */
    public int getCount() {
        int count = getInt();
        if (count < 0 || count > end - next) {
            throw damaged("ends before the " + count + " elements that should follow", next - Integer.BYTES);
        }
        return count;
    }

    /** Checks that all bytes were read. */
    public void finish() {
        if (next != end) {
            throw damaged("has " + (end - next) + " bytes more than expected", next);
        }
    }

    /**
     * Creates an exception about invalid data before the current offset.
     *
     * @param problem the problem, a predicate whose subject is the state, such as "has a robot without a team"
     * @return the exception to throw
     */
    public IllegalArgumentException damaged(String problem) {
        return damaged(problem, next);
    }

    private void need(int count) {
        if (count > end - next) {
            throw damaged("ends in the middle of a number", end);
        }
    }

    private static IllegalArgumentException damaged(String problem, int offset) {
        return new IllegalArgumentException("The saved state " + problem + " (byte " + offset
                + "). It is damaged, or it was written by a different version of RoboNewbie.");
    }
}
