package org.robonewbie.simulator.recording;

import java.nio.charset.StandardCharsets;
import java.util.Arrays;

/** A growable byte buffer for variable-length integers (LEB128) and strings. */
final class ByteSink {

    private byte[] bytes = new byte[256];
    private int length;

    void clear() {
        length = 0;
    }

    byte[] bytes() {
        return bytes;
    }

    int length() {
        return length;
    }

    void putByte(int value) {
        if (length == bytes.length) {
            bytes = Arrays.copyOf(bytes, 2 * length);
        }
        bytes[length++] = (byte) value;
    }

    void putBytes(byte[] source, int count) {
        while (length + count > bytes.length) {
            bytes = Arrays.copyOf(bytes, 2 * bytes.length);
        }
        System.arraycopy(source, 0, bytes, length, count);
        length += count;
    }

    /** Appends an unsigned 64-bit number, seven bits per byte, least significant first. */
    void putUnsigned(long value) {
        long rest = value;
        while ((rest & ~0x7FL) != 0) {
            putByte((int) (rest & 0x7F) | 0x80);
            rest >>>= 7;
        }
        putByte((int) rest);
    }

    /** Appends a signed number in zigzag encoding. */
    void putSigned(long value) {
        putUnsigned((value << 1) ^ (value >> 63));
    }

    void putText(String text) {
        if (isAscii(text)) {
            putUnsigned(text.length());
            for (int i = 0; i < text.length(); i++) {
                putByte(text.charAt(i));
            }
            return;
        }
        byte[] encoded = text.getBytes(StandardCharsets.UTF_8);
        putUnsigned(encoded.length);
        putBytes(encoded, encoded.length);
    }

    private static boolean isAscii(String text) {
        for (int i = 0; i < text.length(); i++) {
            if (text.charAt(i) > 0x7F) {
                return false;
            }
        }
        return true;
    }
}
