package org.robonewbie.pagejvm;

import java.util.List;
import java.util.Map;

/**
 * What a class file says (Java Virtual Machine Specification, chapter 4), as far as it matters for running.
 *
 * @param name of the class, with slashes
 * @param superName of the class that it extends, with slashes
 * @param interfaces names with slashes
 * @param access flags
 * @param constants the constant pool
 * @param fields its own fields
 * @param methods its own methods
 * @param bootstraps how dynamic calls are linked
 */
record ClassFile(
        String name,
        String superName,
        List<String> interfaces,
        int access,
        List<Object> constants,
        List<Field> fields,
        List<MethodCode> methods,
        List<Bootstrap> bootstraps) {

    static final int STATIC = 0x0008;
    static final int INTERFACE = 0x0200;
    static final int ABSTRACT = 0x0400;

    /**
     * A field.
     *
     * @param name its name
     * @param descriptor its type
     * @param isStatic whether the class has it instead of each object
     * @param constant its value from the beginning, if it has one
     */
    record Field(String name, String descriptor, boolean isStatic, java.util.Optional<Object> constant) {}

    /**
     * The code that links a dynamic call.
     *
     * @param handle the method that links
     * @param arguments constants for it
     */
    record Bootstrap(Handle handle, List<Object> arguments) {}

    /**
     * The constant "class".
     *
     * @param name with slashes, or a descriptor of an array
     */
    record TypeName(String name) {}

    /**
     * The constant "method type".
     *
     * @param descriptor such as {@code (I)V}
     */
    record MethodType(String descriptor) {}

    /**
     * The constant "field" or "method".
     *
     * @param owner name of the class with slashes
     * @param name of the member
     * @param descriptor its type
     */
    record Member(String owner, String name, String descriptor) {

        String key() {
            return name + descriptor;
        }
    }

    /**
     * The constant "method handle".
     *
     * @param kind from 1 to 9
     * @param member what it refers to
     */
    record Handle(int kind, Member member) {}

    /**
     * The constant "dynamic call".
     *
     * @param bootstrap index of what links it
     * @param name of the call
     * @param descriptor its type
     */
    record DynamicCall(int bootstrap, String name, String descriptor) {}

    /**
     * A guarded part of a method.
     *
     * @param from first guarded byte
     * @param to the one behind the last
     * @param handler where to go on
     * @param type name of the exception with slashes; empty for all
     */
    record Guard(int from, int to, int handler, String type) {}

    /**
     * The code of a method.
     *
     * @param name its name
     * @param descriptor its type
     * @param access flags
     * @param code instructions; empty if there are none
     * @param locals number of its variables
     * @param stack most values that it lays down
     * @param guards its guarded parts
     * @param lines line by first byte of its code
     * @param source name of the file with its text
     */
    @SuppressWarnings("ArrayRecordComponent") // of this package, and never compared
    record MethodCode(
            String name,
            String descriptor,
            int access,
            byte[] code,
            int locals,
            int stack,
            List<Guard> guards,
            Map<Integer, Integer> lines,
            String source) {

        boolean isStatic() {
            return (access & STATIC) != 0;
        }

        boolean isAbstract() {
            return (access & ABSTRACT) != 0;
        }

        String key() {
            return name + descriptor;
        }

        /** {@return the line of the text in which an instruction stands} */
        int line(int at) {
            int best = -1;
            int line = -1;
            for (Map.Entry<Integer, Integer> entry : lines.entrySet()) {
                if (entry.getKey() <= at && entry.getKey() > best) {
                    best = entry.getKey();
                    line = entry.getValue();
                }
            }
            return line;
        }
    }
}
