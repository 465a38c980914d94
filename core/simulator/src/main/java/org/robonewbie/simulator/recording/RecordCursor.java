package org.robonewbie.simulator.recording;

import java.nio.charset.StandardCharsets;

/** Reads numbers and texts from bytes that are already there, as a {@link ByteSink} has written them. */
final class RecordCursor {

    private final byte[] bytes;
    private final int end;
    private int at;

    RecordCursor(byte[] bytes, int from, int end) {
        this.bytes = bytes;
        this.at = from;
        this.end = end;
    }

    int position() {
        return at;
    }

    boolean isAtEnd() {
        return at >= end;
    }

    int getByte() {
        if (at >= end) {
            throw new IndexOutOfBoundsException(at);
        }
        return bytes[at++] & 0xFF;
    }

    long getUnsigned() {
        long value = 0;
        for (int shift = 0; shift < 64; shift += 7) {
            int next = getByte();
            value |= (long) (next & 0x7F) << shift;
            if (next < 0x80) {
                break;
            }
        }
        return value;
    }

    long getSigned() {
        long value = getUnsigned();
        return (value >>> 1) ^ -(value & 1);
    }

    /** Goes on behind some bytes, and returns where they began. */
    int skip(long count) {
        if (count < 0 || count > end - at) {
            throw new IndexOutOfBoundsException(at);
        }
        int begin = at;
        at += (int) count;
        return begin;
    }

    /** A number of things that follow, each of which takes a byte at least. */
    int getCount() {
        long count = getUnsigned();
        if (count < 0 || count > end - at) {
            throw new IndexOutOfBoundsException(at);
        }
        return (int) count;
    }

    String getText() {
        int length = getCount();
        return new String(bytes, skip(length), length, StandardCharsets.UTF_8);
    }
}
