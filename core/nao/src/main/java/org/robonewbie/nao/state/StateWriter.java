package org.robonewbie.nao.state;

import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import java.util.Collection;
import java.util.Optional;
import java.util.function.Consumer;
import org.robonewbie.nao.Vector3;

/**
 * Collects numbers and texts as bytes, without any rounding: integers and the bits of doubles with the low byte first, texts
 * in UTF-8 behind their length.
 */
public final class StateWriter {

    private byte[] bytes = new byte[1 << 13];
    private int length;

    /** Creates an empty writer. */
    public StateWriter() {}

    /**
     * Appends a yes or no.
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
     * Appends a number with all its bits.
     *
     * @param value the value
     */
    public void putDouble(double value) {
        putLong(Double.doubleToRawLongBits(value));
    }

    /**
     * Appends as many numbers as an array has; its length is not written.
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
     * Appends a constant of an enum by its place.
     *
     * @param constant the constant
     */
    public void putEnum(Enum<?> constant) {
        putInt(constant.ordinal());
    }

    /**
     * Appends bytes behind their number.
     *
     * @param source where they are
     * @param count how many of them, from the first
     */
    public void putBytes(byte[] source, int count) {
        putInt(count);
        reserve(count);
        System.arraycopy(source, 0, bytes, length, count);
        length += count;
    }

    /**
     * Appends a text.
     *
     * @param text any text
     */
    public void putText(String text) {
        byte[] encoded = text.getBytes(StandardCharsets.UTF_8);
        putBytes(encoded, encoded.length);
    }

    /**
     * Appends a value that may be missing.
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
     * Appends all elements of a collection behind their number.
     *
     * @param <T> type of the elements
     * @param elements the elements, in an order that does not depend on chance
     * @param writer writes one element
     */
    public <T> void putAll(Collection<T> elements, Consumer<? super T> writer) {
        putInt(elements.size());
        elements.forEach(writer);
    }

    /**
     * {@return a copy of all bytes so far}
     */
    public byte[] toBytes() {
        return Arrays.copyOf(bytes, length);
    }

    private void reserve(int more) {
        if (length + more > bytes.length) {
            bytes = Arrays.copyOf(bytes, Math.max(length + more, 2 * bytes.length));
        }
    }
}
