package org.robonewbie.protocol.frame;

import java.nio.charset.StandardCharsets;
import java.util.Arrays;

/**
 * The bytes of one message without its length prefix; it grows as needed and is used again for each cycle, so that a
 * running robot makes no garbage.
 */
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
     * Gives access to the bytes themselves; they change with the next message.
     *
     * @return the array, of which the first {@link #length()} bytes are the message
     */
    public byte[] bytes() {
        return bytes;
    }

    /**
     * Tells how long the message is.
     *
     * @return the number of bytes, at least 0
     */
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
     * Appends a text in UTF-8, so that no letter of a foreign alphabet can pass for a parenthesis.
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
     * @param other the message, left as it is
     */
    public void append(MessageBuffer other) {
        int start = length;
        resize(length + other.length);
        System.arraycopy(other.bytes, 0, bytes, start, other.length);
    }

    private void appendEncoded(byte[] encoded) {
        int start = length;
        resize(length + encoded.length);
        System.arraycopy(encoded, 0, bytes, start, encoded.length);
    }

    /**
     * Shows the message as text.
     *
     * @return the message, read as UTF-8
     */
    @Override
    public String toString() {
        return new String(bytes, 0, length, StandardCharsets.UTF_8);
    }
}
