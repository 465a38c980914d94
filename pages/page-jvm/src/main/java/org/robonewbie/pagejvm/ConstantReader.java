package org.robonewbie.pagejvm;

import java.io.DataInputStream;
import java.io.IOException;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import org.robonewbie.pagejvm.ClassFile.DynamicCall;
import org.robonewbie.pagejvm.ClassFile.Handle;
import org.robonewbie.pagejvm.ClassFile.Member;
import org.robonewbie.pagejvm.ClassFile.MethodType;
import org.robonewbie.pagejvm.ClassFile.TypeName;

/** Parser of the constant pool of a class file. */
final class ConstantReader {

    /** An empty constant pool. */
    static final ConstantReader NONE = new ConstantReader(0);

    private static final Object UNUSED = "";

    private final Object[] raw;
    private final int[][] parts;
    private final int[] tags;

    private ConstantReader(int count) {
        raw = new Object[count];
        parts = new int[count][];
        tags = new int[count];
        Arrays.fill(raw, UNUSED);
    }

    static ConstantReader read(DataInputStream input) throws IOException {
        ConstantReader reader = new ConstantReader(input.readUnsignedShort());
        for (int i = 1; i < reader.raw.length; i++) {
            int tag = reader.readOne(i, input);
            if (tag == 5 || tag == 6) { // long and double take two entries
                i++;
            }
        }
        return reader;
    }

    private int readOne(int index, DataInputStream input) throws IOException {
        int tag = input.readUnsignedByte();
        tags[index] = tag;
        switch (tag) {
            case 1 -> raw[index] = input.readUTF();
            case 3 -> raw[index] = input.readInt();
            case 4 -> raw[index] = input.readFloat();
            case 5 -> raw[index] = input.readLong();
            case 6 -> raw[index] = input.readDouble();
            case 7, 8, 16, 19, 20 -> parts[index] = new int[] {input.readUnsignedShort()};
            case 15 -> parts[index] = new int[] {input.readUnsignedByte(), input.readUnsignedShort()};
            default -> parts[index] = new int[] {input.readUnsignedShort(), input.readUnsignedShort()};
        }
        return tag;
    }

    String text(int index) {
        return (String) raw[index];
    }

    Object get(int index) {
        int[] part = parts[index];
        if (part == null) {
            return raw[index];
        }
        return switch (tags[index]) {
            case 7 -> new TypeName(text(part[0]));
            case 8 -> text(part[0]);
            case 9, 10, 11 -> new Member(((TypeName) get(part[0])).name(), name(part[1]), descriptor(part[1]));
            case 15 -> new Handle(part[0], (Member) get(part[1]));
            case 16 -> new MethodType(text(part[0]));
            case 17, 18 -> new DynamicCall(part[0], name(part[1]), descriptor(part[1]));
            default -> UNUSED;
        };
    }

    private String name(int index) {
        return text(parts[index][0]);
    }

    private String descriptor(int index) {
        return text(parts[index][1]);
    }

    /** {@return all constants by index} */
    List<Object> all() {
        List<Object> all = new ArrayList<>();
        for (int i = 0; i < raw.length; i++) {
            all.add(get(i));
        }
        return List.copyOf(all);
    }
}
