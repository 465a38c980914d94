package org.robonewbie.nao.state;

import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import java.util.Collection;
import java.util.Optional;
import java.util.function.Consumer;
import org.robonewbie.nao.Vector3;

/**
 * Serializes values to bytes without loss: integers and the bits of doubles in little-endian order, and strings in
 * UTF-8, preceded by their length.
 */
public final class StateWriter {

    private byte[] bytes = new byte[1 << 13];
    private int length;

    /** Creates an empty writer. */
    public StateWriter() {}

    /**
     * Appends a boolean.
     *
     * @param value the value
     */
    public void putBoolean(boolean value) {
        reserve(1);
        bytes[length++] = (byte) (value ? 1 : 0);
    }

    /**
     * Appends an integer.
     *
     * @param value the value
     */
    public void putInt(int value) {
        reserve(Integer.BYTES);
        for (int shift = 0; shift < Integer.SIZE; shift += Byte.SIZE) {
            bytes[length++] = (byte) (value >>> shift);
        }
    }

    /**
     * Appends a long integer.
     *
     * @param value the value
     */
    public void putLong(long value) {
        reserve(Long.BYTES);
        for (int shift = 0; shift < Long.SIZE; shift += Byte.SIZE) {
            bytes[length++] = (byte) (value >>> shift);
        }
    }

    /**
     * Appends a double, which is restored bit for bit.
     *
     * @param value the value
     */
    public void putDouble(double value) {
        putLong(Double.doubleToRawLongBits(value));
    }

    /**
     * Appends the elements of an array without its length.
     *
     * @param values the values
     */
    public void putDoubles(double[] values) {
        for (double value : values) {
            putDouble(value);
        }
    }

    /**
     * Appends a vector.
     *
     * @param vector the vector
     */
    public void putVector(Vector3 vector) {
        putDouble(vector.x());
        putDouble(vector.y());
        putDouble(vector.z());
    }

    /**
     * Appends the ordinal of an enum constant.
     *
     * @param constant the constant
     */
    public void putEnum(Enum<?> constant) {
        putInt(constant.ordinal());
    }

    /**
     * Appends the first bytes of an array, preceded by their count.
     *
     * @param source the array
     * @param count number of bytes to append
     */
    public void putBytes(byte[] source, int count) {
        putInt(count);
        reserve(count);
        System.arraycopy(source, 0, bytes, length, count);
        length += count;
    }

    /**
     * Appends a string.
     *
     * @param text any string
     */
    public void putText(String text) {
        byte[] encoded = text.getBytes(StandardCharsets.UTF_8);
        putBytes(encoded, encoded.length);
    }

    /**
     * Appends an optional value.
     *
     * @param <T> type of the value
     * @param value the value, or empty
     * @param writer writes the value if there is one
     */
    public <T> void putOptional(Optional<T> value, Consumer<? super T> writer) {
        putBoolean(value.isPresent());
        value.ifPresent(writer);
    }

    /**
     * Appends all elements of a collection, preceded by their count.
     *
     * @param <T> type of the elements
     * @param elements the elements, in a deterministic order
     * @param writer writes one element
     */
    public <T> void putAll(Collection<T> elements, Consumer<? super T> writer) {
        putInt(elements.size());
        elements.forEach(writer);
    }

    /** {@return a copy of all bytes written so far} */
    public byte[] toBytes() {
        return Arrays.copyOf(bytes, length);
    }

    private void reserve(int more) {
        if (length + more > bytes.length) {
            bytes = Arrays.copyOf(bytes, Math.max(length + more, 2 * bytes.length));
        }
    }
}
