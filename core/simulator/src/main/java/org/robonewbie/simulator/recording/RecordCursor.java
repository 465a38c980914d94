package org.robonewbie.simulator.recording;

import java.nio.charset.StandardCharsets;

/** A reader of bytes written by a {@link ByteSink}. Reading past the end throws an {@link IndexOutOfBoundsException}. */
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

    /** Skips bytes and returns the index of the first skipped byte. */
    int skip(long count) {
        if (count < 0 || count > end - at) {
            throw new IndexOutOfBoundsException(at);
        }
        int begin = at;
        at += (int) count;
        return begin;
    }

    /** Reads the number of elements that follow, each at least one byte long. */
    int getCount() {
        long count = getUnsigned();
        if (count < 0 || count > end - at) {
            throw new IndexOutOfBoundsException(at);
        }
        return (int) count;
    }

    int getIndex(int size) {
        long index = getUnsigned();
        if (index < 0 || index >= size) {
            throw new IndexOutOfBoundsException(at);
        }
        return (int) index;
    }

    String getText() {
        int length = getCount();
        return new String(bytes, skip(length), length, StandardCharsets.UTF_8);
    }
}
