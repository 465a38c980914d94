package org.robonewbie.protocol.frame;

import java.nio.charset.StandardCharsets;
import java.util.Arrays;

/** The bytes of one message without its length prefix. It grows as needed and is reused in each cycle. */
public final class MessageBuffer {

    private static final char LAST_ASCII = 0x7F;

    private byte[] bytes;
    private int length;

    /** Creates an empty buffer. */
    public MessageBuffer() {
        this(1024);
    }

    /**
     * Creates an empty buffer.
     *
     * @param capacity how many bytes fit in before it grows, at least 1
     */
    public MessageBuffer(int capacity) {
        bytes = new byte[capacity];
    }

    /**
     * {@return the underlying array, of which the first {@link #length()} bytes are the message; it changes with the next
     * message}
     */
    public byte[] bytes() {
        return bytes;
    }

    /** {@return the length of the message in bytes, at least 0} */
    public int length() {
        return length;
    }

    /** Makes the message empty. */
    public void clear() {
        length = 0;
    }

    /**
     * Makes room for a message that the caller then writes into {@link #bytes()}.
     *
     * @param newLength length of the message in bytes; the bytes before the old length are kept
     */
    public void resize(int newLength) {
        if (newLength > bytes.length) {
            bytes = Arrays.copyOf(bytes, Math.max(newLength, 2 * bytes.length));
        }
        length = newLength;
    }

    /**
     * Appends one byte.
     *
     * @param value the byte
     */
    public void append(byte value) {
        resize(length + 1);
        bytes[length - 1] = value;
    }

    /**
     * Appends a text in UTF-8, in which no letter of a foreign alphabet can be mistaken for a parenthesis.
     *
     * @param text the text, mostly ASCII
     */
    public void append(CharSequence text) {
        int start = length;
        resize(length + text.length());
        for (int i = 0; i < text.length(); i++) {
            char character = text.charAt(i);
            if (character > LAST_ASCII) {
                resize(start);
                appendEncoded(text.toString().getBytes(StandardCharsets.UTF_8));
                return;
            }
            bytes[start + i] = (byte) character;
        }
    }

    /**
     * Appends another message.
     *
     * @param other the message, left unchanged
     */
    public void append(MessageBuffer other) {
        int start = length;
        resize(length + other.length);
        System.arraycopy(other.bytes, 0, bytes, start, other.length);
    }

    /**
     * Replaces the message.
     *
     * @param message the bytes of the new message, which are copied
     */
    public void set(byte[] message) {
        length = 0;
        resize(message.length);
        System.arraycopy(message, 0, bytes, 0, message.length);
    }

    private void appendEncoded(byte[] encoded) {
        int start = length;
        resize(length + encoded.length);
        System.arraycopy(encoded, 0, bytes, start, encoded.length);
    }

    /** {@return the message, decoded as UTF-8} */
    @Override
    public String toString() {
        return new String(bytes, 0, length, StandardCharsets.UTF_8);
    }
}
