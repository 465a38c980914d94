package org.robonewbie.protocol.frame;

import java.nio.charset.StandardCharsets;
import java.util.Arrays;

/** Growable buffer for one message without its length prefix. Reuse it in each cycle to avoid allocations. */
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
     * @param capacity initial capacity in bytes, at least 1
     */
    public MessageBuffer(int capacity) {
        bytes = new byte[capacity];
    }

    /**
     * {@return the underlying array, whose first {@link #length()} bytes are the message; valid until the next change}
     */
    public byte[] bytes() {
        return bytes;
    }

    /** {@return the length of the message in bytes} */
    public int length() {
        return length;
    }

    /** Sets the length to 0. */
    public void clear() {
        length = 0;
    }

    /**
     * Changes the length of the message, keeping its existing bytes. The caller then writes the new bytes into {@link
     * #bytes()}.
     *
     * @param newLength the new length in bytes
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
     * Appends text encoded as UTF-8. No byte of a non-ASCII character equals a parenthesis, so such text cannot break
     * the syntax.
     *
     * @param text the text, mostly ASCII
     */
    public void append(CharSequence text) {
        int start = length;
        resize(length + text.length());
        for (int i = 0; i < text.length(); i++) {
            char character = text.charAt(i);
            if (character > LAST_ASCII) {
                length = start;
                append(text.toString().getBytes(StandardCharsets.UTF_8));
                return;
            }
            bytes[start + i] = (byte) character;
        }
    }

    /**
     * Appends another message.
     *
     * @param other the message
     */
    public void append(MessageBuffer other) {
        int start = length;
        resize(length + other.length);
        System.arraycopy(other.bytes, 0, bytes, start, other.length);
    }

    /**
     * Replaces the message.
     *
     * @param message the bytes of the new message; copied
     */
    public void set(byte[] message) {
        length = 0;
        append(message);
    }

    private void append(byte[] encoded) {
        int start = length;
        resize(length + encoded.length);
        System.arraycopy(encoded, 0, bytes, start, encoded.length);
    }

    /**
     * Returns whether the message starts with a text.
     *
     * @param text the text, in ASCII
     * @return whether the first bytes are those of the text
     */
    public boolean startsWith(String text) {
        boolean equal = length >= text.length();
        for (int i = 0; equal && i < text.length(); i++) {
            equal = bytes[i] == text.charAt(i);
        }
        return equal;
    }

    /** {@return the message, decoded as UTF-8} */
    @Override
    public String toString() {
        return new String(bytes, 0, length, StandardCharsets.UTF_8);
    }
}
