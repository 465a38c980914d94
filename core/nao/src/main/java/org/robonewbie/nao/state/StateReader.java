package org.robonewbie.nao.state;

import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.Supplier;
import org.robonewbie.nao.Vector3;

/**
 * Reads back what a {@link StateWriter} wrote, in the same order. Every problem is an {@link IllegalArgumentException} that
 * names the byte at which it was found.
 */
public final class StateReader {

    private final byte[] bytes;
    private final int end;
    private int next;

    /**
     * Reads from the first byte on.
     *
     * @param bytes what {@link StateWriter#toBytes()} returned; must not change while it is read
     */
    public StateReader(byte[] bytes) {
        this(bytes, 0);
    }

    /**
     * Reads from some byte on.
     *
     * @param bytes the bytes; must not change while they are read
     * @param start the first byte to read
     */
    public StateReader(byte[] bytes, int start) {
        this.bytes = bytes;
        this.end = bytes.length;
        this.next = start;
    }

    /** {@return the next yes or no} */
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

    /** {@return the next number, with all its bits} */
    public double getDouble() {
        return Double.longBitsToDouble(getLong());
    }

    /**
     * Reads the next numbers into an array.
     *
     * @param target receives as many numbers as it is long
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
     * Reads a constant of an enum.
     *
     * @param <E> the enum
     * @param constants all of its constants
     * @return the next constant
     */
    public <E extends Enum<E>> E getEnum(E[] constants) {
        return constants[getIndex(constants.length)];
    }

    /**
     * Reads an index.
     *
     * @param count how many things there are
     * @return the next integer, at least 0 and less than count
     */
    public int getIndex(int count) {
        int index = getInt();
        if (index < 0 || index >= count) {
            throw damaged("has number " + index + " of " + count, next - Integer.BYTES);
        }
        return index;
    }

    /** {@return the next bytes} */
    public byte[] getBytes() {
        int count = getInt();
        if (count < 0 || count > end - next) {
            throw damaged("has no room for " + count + " more bytes", next - Integer.BYTES);
        }
        byte[] copy = new byte[count];
        System.arraycopy(bytes, next, copy, 0, count);
        next += count;
        return copy;
    }

    /** {@return the next text} */
    public String getText() {
        return new String(getBytes(), StandardCharsets.UTF_8);
    }

    /**
     * Reads a value that may be missing.
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
     * @param reader reads one element, which takes at least one byte
     * @return the elements in their order, a new list
     */
    public <T> List<T> getAll(Supplier<T> reader) {
        int count = getCount();
        List<T> elements = new ArrayList<>(count);
        for (int i = 0; i < count; i++) {
            elements.add(reader.get());
        }
        return elements;
    }

    /** {@return how many elements follow, each of at least one byte} */
    public int getCount() {
        int count = getInt();
        if (count < 0 || count > end - next) {
            throw damaged("announces " + count + " elements, more than the rest can hold", next - Integer.BYTES);
        }
        return count;
    }

    /** Checks that everything was read. */
    public void finish() {
        if (next != end) {
            throw damaged("goes on for " + (end - next) + " bytes after its end", next);
        }
    }

    /**
     * Describes damage at the place that was read last.
     *
     * @param problem what is wrong, a part of a sentence whose subject is the state, such as "has a robot without team"
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

    private static IllegalArgumentException damaged(String problem, int place) {
        return new IllegalArgumentException("The saved state " + problem + " (byte " + place
                + "). It is damaged, or another version of RoboNewbie wrote it.");
    }
}
