package org.robonewbie.studio.replay;

/** Header of a gzip file (RFC 1952). */
final class GzipHeader {

    private static final int FIXED_BYTES = 10;
    private static final int CHECKSUM = 2;
    private static final int EXTRA = 4;
    private static final int NAME = 8;
    private static final int COMMENT = 16;

    private GzipHeader() {}

    /** Returns the length of the header; 0 if it is incomplete. */
    static int length(byte[] bytes, int count) {
        if (count < FIXED_BYTES) {
            return 0;
        }
        int flags = bytes[3];
        int at = FIXED_BYTES;
        if ((flags & EXTRA) != 0) {
            at += 2 + (bytes[at] & 0xFF) + 256 * (bytes[at + 1] & 0xFF);
        }
        for (int text : new int[] {NAME, COMMENT}) {
            at = (flags & text) == 0 ? at : behindText(bytes, at, count);
        }
        return Math.min(count, at + ((flags & CHECKSUM) == 0 ? 0 : 2));
    }

    private static int behindText(byte[] bytes, int from, int count) {
        int at = from;
        while (at < count && bytes[at] != 0) {
            at++;
        }
        return at + 1;
    }
}
