package org.robonewbie.learning.dataset;

import java.io.ByteArrayOutputStream;
import java.nio.charset.StandardCharsets;
import java.util.ArrayDeque;
import java.util.Deque;

/**
 * Writes structures of numbers in Apache Thrift's compact protocol, in which Parquet describes itself: each field begins with
 * the distance of its number from the last one and its type, numbers have seven bits per byte.
 */
final class CompactThrift {

    private static final int NUMBER_32 = 5;
    private static final int NUMBER_64 = 6;
    private static final int BYTES = 8;
    private static final int LIST = 9;
    private static final int STRUCTURE = 12;
    private static final int LONG_LIST = 15;

    private final ByteArrayOutputStream out = new ByteArrayOutputStream();
    private final Deque<Integer> outerFields = new ArrayDeque<>();
    private int lastField;

    CompactThrift number(int field, int value) {
        begin(field, NUMBER_32);
        writeSigned(value);
        return this;
    }

    CompactThrift longNumber(int field, long value) {
        begin(field, NUMBER_64);
        writeSigned(value);
        return this;
    }

    CompactThrift text(int field, String value) {
        return bytes(field, value.getBytes(StandardCharsets.UTF_8));
    }

    CompactThrift bytes(int field, byte... value) {
        begin(field, BYTES);
        writeBytes(value);
        return this;
    }

    CompactThrift numbers(int field, int... values) {
        beginList(field, NUMBER_32, values.length);
        for (int value : values) {
            writeSigned(value);
        }
        return this;
    }

    CompactThrift texts(int field, String... values) {
        beginList(field, BYTES, values.length);
        for (String value : values) {
            writeBytes(value.getBytes(StandardCharsets.UTF_8));
        }
        return this;
    }

    /** Begins a field that contains fields of its own, until {@link #end}. */
    CompactThrift structure(int field) {
        begin(field, STRUCTURE);
        return element();
    }

    /** Begins a field of several structures, each of which begins with {@link #element}. */
    CompactThrift structures(int field, int count) {
        beginList(field, STRUCTURE, count);
        return this;
    }

    CompactThrift element() {
        outerFields.push(lastField);
        lastField = 0;
        return this;
    }

    /** Ends a structure. */
    CompactThrift end() {
        out.write(0);
        lastField = outerFields.pop();
        return this;
    }

    /** Ends the outermost structure and gives all. */
    byte[] toBytes() {
        out.write(0);
        return out.toByteArray();
    }

    private void begin(int field, int type) {
        out.write(((field - lastField) << 4) | type);
        lastField = field;
    }

    private void beginList(int field, int type, int count) {
        begin(field, LIST);
        out.write((Math.min(count, LONG_LIST) << 4) | type);
        if (count >= LONG_LIST) {
            writeUnsigned(count);
        }
    }

    private void writeBytes(byte... bytes) {
        writeUnsigned(bytes.length);
        out.writeBytes(bytes);
    }

    private void writeSigned(long value) {
        writeUnsigned((value << 1) ^ (value >> 63));
    }

    private void writeUnsigned(long value) {
        writeUnsigned(out, value);
    }

    /** Writes a number with seven bits per byte, the lowest first, as Parquet's levels want it too. */
    static void writeUnsigned(ByteArrayOutputStream out, long value) {
        long rest = value;
        while ((rest & ~0x7FL) != 0) {
            out.write((int) ((rest & 0x7F) | 0x80));
            rest >>>= 7;
        }
        out.write((int) rest);
    }
}
