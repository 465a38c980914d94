package org.robonewbie.protocol.tcp;

import org.robonewbie.protocol.frame.MessageBuffer;

/** The length prefix of a message: four bytes in big-endian order. The length does not include the prefix. */
final class LengthPrefix {

    static final int BYTES = 4;

    private LengthPrefix() {}

    static int read(byte[] bytes, int start, int maxBytes) throws FrameTooLongException {
        long length = 0;
        for (int i = start; i < start + BYTES; i++) {
            length = 256 * length + (bytes[i] & 0xFF);
        }
        if (length > maxBytes) {
            throw new FrameTooLongException(length, maxBytes);
        }
        return (int) length;
    }

    /** Appends a message with its prefix to a buffer. */
    static void append(MessageBuffer message, MessageBuffer frame) {
        int length = message.length();
        for (int shift = 24; shift >= 0; shift -= 8) {
            frame.append((byte) (length >>> shift));
        }
        frame.append(message);
    }
}
