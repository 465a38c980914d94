package org.robonewbie.learning.dataset;

import java.nio.ByteBuffer;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;

/** Reads a structure of Thrift's compact protocol, the counterpart of {@link CompactThrift}: numbers as Long, bytes as they are, lists as List, structures as Map by field. */
record ThriftFields(ByteBuffer in) {

    Map<Integer, Object> structure() {
        Map<Integer, Object> fields = new TreeMap<>();
        int field = 0;
        for (int head = in.get() & 0xFF; head != 0; head = in.get() & 0xFF) {
            field = head >> 4 == 0 ? (int) signed() : field + (head >> 4);
            fields.put(field, value(head & 0x0F));
        }
        return fields;
    }

    private Object value(int type) {
        return switch (type) {
            case 5, 6 -> signed();
            case 8 -> bytes();
            case 9 -> list();
            case 12 -> structure();
            default -> throw new IllegalArgumentException("type " + type);
        };
    }

    private List<Object> list() {
        int head = in.get() & 0xFF;
        long count = head >> 4 == 15 ? unsigned() : head >> 4;
        List<Object> all = new ArrayList<>();
        for (long i = 0; i < count; i++) {
            all.add(value(head & 0x0F));
        }
        return all;
    }

    private byte[] bytes() {
        long count = unsigned();
        if (count < 0 || count > in.remaining()) {
            throw new IllegalArgumentException(count + " bytes");
        }
        byte[] bytes = new byte[(int) count];
        in.get(bytes);
        return bytes;
    }

    private long signed() {
        long number = unsigned();
        return (number >>> 1) ^ -(number & 1);
    }

    private long unsigned() {
        long number = 0;
        for (int shift = 0; ; shift += 7) {
            int next = in.get();
            number |= (long) (next & 0x7F) << shift;
            if (next >= 0) {
                return number;
            }
        }
    }
}
