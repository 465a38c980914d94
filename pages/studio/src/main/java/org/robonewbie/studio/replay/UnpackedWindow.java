package org.robonewbie.studio.replay;

/** Sliding window of DEFLATE: the last 32 KiB of the uncompressed stream, to which later bytes may refer. */
final class UnpackedWindow {

    private static final int BYTES = 1 << 15;

    private final byte[] ring = new byte[BYTES];
    private long written;

    void add(byte[] bytes, int count) {
        for (int i = Math.max(0, count - BYTES); i < count; i++) {
            ring[(int) ((written + i) % BYTES)] = bytes[i];
        }
        written += count;
    }

    /** {@return the total number of bytes added} */
    long written() {
        return written;
    }

    byte[] content() {
        int length = (int) Math.min(written, BYTES);
        byte[] content = new byte[length];
        for (int i = 0; i < length; i++) {
            content[i] = ring[(int) ((written - length + i) % BYTES)];
        }
        return content;
    }
}
