package org.robonewbie.pagejvm;

import java.lang.reflect.Array;
import java.util.Objects;
import org.jspecify.annotations.Nullable;
import org.robonewbie.pagejvm.ClassFile.TypeName;

/** Instructions for arrays and their elements. */
final class ArrayInstructions {

    private static final String[] PRIMITIVES = {"Z", "C", "F", "D", "B", "S", "I", "J"};
    private static final int FIRST_PRIMITIVE = 4;

    private ArrayInstructions() {}

    /** Loads or stores an element. */
    static void element(int code, Frame frame) {
        if (code <= 53) {
            int index = frame.popInt();
            frame.push(read(array(frame), index));
        } else {
            Object value = frame.pop();
            int index = frame.popInt();
            write(array(frame), index, value);
        }
    }

    private static Object array(Frame frame) {
        return Objects.requireNonNull(frame.pop(), "The array is null.");
    }

    static @Nullable Object read(Object array, int index) {
        if (array instanceof double[] numbers) {
            return numbers[checked(index, numbers.length)];
        }
        if (array instanceof int[] numbers) {
            return numbers[checked(index, numbers.length)];
        }
        if (array instanceof Object[] objects) {
            return objects[checked(index, objects.length)];
        }
        return Compiled.fromJava(Array.get(array, checked(index, Array.getLength(array))));
    }

    static void write(Object array, int index, @Nullable Object value) {
        if (array instanceof double[] numbers) {
            numbers[checked(index, numbers.length)] = (Double) Objects.requireNonNull(value);
        } else if (array instanceof int[] numbers) {
            numbers[checked(index, numbers.length)] = (Integer) Objects.requireNonNull(value);
        } else if (array instanceof Object[] objects) {
            objects[checked(index, objects.length)] = value;
        } else {
            checked(index, Array.getLength(array));
            writeSmall(array, index, Objects.requireNonNull(value));
        }
    }

    private static void writeSmall(Object array, int index, Object value) {
        if (array instanceof boolean[] truths) {
            truths[index] = ((Integer) value & 1) != 0;
        } else if (array instanceof char[] characters) {
            characters[index] = (char) (int) (Integer) value;
        } else if (array instanceof byte[] bytes) {
            bytes[index] = (byte) (int) (Integer) value;
        } else if (array instanceof short[] numbers) {
            numbers[index] = (short) (int) (Integer) value;
        } else {
            Array.set(array, index, value);
        }
    }

    private static int checked(int index, int length) {
        if (index < 0 || index >= length) {
            throw new ArrayIndexOutOfBoundsException("Index " + index + " out of bounds for length " + length);
        }
        return index;
    }

    /** Creates an array, or pushes its length. */
    static void array(int code, Frame frame, Program program) {
        switch (code) {
            case 188 -> frame.push(create("[" + PRIMITIVES[frame.u1() - FIRST_PRIMITIVE], program, frame.popInt()));
            case 189 -> {
                String name = ((TypeName) frame.constant()).name();
                frame.push(create(name.startsWith("[") ? "[" + name : "[L" + name + ";", program, frame.popInt()));
            }
            case 190 -> frame.push(Array.getLength(array(frame)));
            default -> {
                String type = ((TypeName) frame.constant()).name();
                int[] lengths = new int[frame.u1()];
                for (int i = lengths.length - 1; i >= 0; i--) {
                    lengths[i] = frame.popInt();
                }
                frame.push(create(type, program, lengths));
            }
        }
    }

    /** Creates a multidimensional array. */
    private static Object create(String type, Program program, int... lengths) {
        if (lengths[0] < 0) {
            throw new NegativeArraySizeException("" + lengths[0]);
        }
        Object array = Array.newInstance(program.compiled().javaType(type.substring(1)), lengths[0]);
        if (lengths.length > 1) {
            int[] inner = java.util.Arrays.copyOfRange(lengths, 1, lengths.length);
            for (int i = 0; i < lengths[0]; i++) {
                Array.set(array, i, create(type.substring(1), program, inner));
            }
        }
        return array;
    }
}
