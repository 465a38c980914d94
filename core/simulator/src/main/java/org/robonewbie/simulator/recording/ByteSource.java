package org.robonewbie.simulator.recording;

import java.io.DataInputStream;
import java.io.EOFException;
import java.io.IOException;
import java.nio.charset.StandardCharsets;

/** Reads what a {@link ByteSink} has collected. */
final class ByteSource {

    private static final int MAX_TEXT_BYTES = 1 << 20;

    private final DataInputStream in;

    ByteSource(DataInputStream in) {
        this.in = in;
    }

    int getByte() throws IOException {
        return in.readUnsignedByte();
    }

    byte[] getBytes(long count) throws IOException {
        if (count < 0 || count > MAX_TEXT_BYTES) {
            throw new DamagedRecordingException(
                    "A piece of " + count + " bytes is too long for a recording. The file is damaged.");
        }
        byte[] bytes = in.readNBytes((int) count);
        if (bytes.length < count) {
            throw new EOFException();
        }
        return bytes;
    }

    long getUnsigned() throws IOException {
        long value = 0;
        for (int shift = 0; shift < 64; shift += 7) {
            int next = in.readUnsignedByte();
            value |= (long) (next & 0x7F) << shift;
            if (next < 0x80) {
                return value;
            }
        }
        throw new DamagedRecordingException("A number in the recording does not end. The file is damaged.");
    }

    long getSigned() throws IOException {
        long value = getUnsigned();
        return (value >>> 1) ^ -(value & 1);
    }

    String getText() throws IOException {
        return new String(getBytes(getUnsigned()), StandardCharsets.UTF_8);
    }
}
