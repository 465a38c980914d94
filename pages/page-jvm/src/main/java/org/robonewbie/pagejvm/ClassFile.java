package org.robonewbie.pagejvm;

import java.util.List;
import java.util.Map;

/**
 * The parts of a class file (Java Virtual Machine Specification, chapter 4) that are relevant to execution.
 *
 * @param name internal name of the class, such as {@code java/lang/String}
 * @param superName internal name of the superclass
 * @param interfaces internal names of the interfaces
 * @param access access flags
 * @param constants the constant pool
 * @param fields declared fields
 * @param methods declared methods
 * @param bootstraps bootstrap methods of dynamic calls
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
     * @param isStatic whether it is static
     * @param constant its constant value, if it has one
     */
    record Field(String name, String descriptor, boolean isStatic, java.util.Optional<Object> constant) {}

    /**
     * Bootstrap method of a dynamic call.
     *
     * @param handle the bootstrap method
     * @param arguments its static arguments
     */
    record Bootstrap(Handle handle, List<Object> arguments) {}

    /**
     * The constant CONSTANT_Class.
     *
     * @param name internal name of a class, or descriptor of an array
     */
    record TypeName(String name) {}

    /**
     * The constant CONSTANT_MethodType.
     *
     * @param descriptor descriptor such as {@code (I)V}
     */
    record MethodType(String descriptor) {}

    /**
     * The constants CONSTANT_Fieldref and CONSTANT_Methodref.
     *
     * @param owner internal name of the class
     * @param name name of the member
     * @param descriptor its type
     */
    record Member(String owner, String name, String descriptor) {

        String key() {
            return name + descriptor;
        }
    }

    /**
     * The constant CONSTANT_MethodHandle.
     *
     * @param kind reference kind from 1 to 9
     * @param member the referenced member
     */
    record Handle(int kind, Member member) {}

    /**
     * The constant CONSTANT_InvokeDynamic.
     *
     * @param bootstrap index of the bootstrap method
     * @param name name of the call
     * @param descriptor its type
     */
    record DynamicCall(int bootstrap, String name, String descriptor) {}

    /**
     * Entry of an exception table.
     *
     * @param from offset of the first guarded byte
     * @param to offset after the last guarded byte
     * @param handler offset of the exception handler
     * @param type internal name of the exception class; empty for all exceptions
     */
    record Guard(int from, int to, int handler, String type) {}

    /**
     * The code of a method.
     *
     * @param name its name
     * @param descriptor its type
     * @param access access flags
     * @param code bytecode; empty if there is none
     * @param locals number of local variables
     * @param stack maximum depth of the operand stack
     * @param guards the exception table
     * @param lines line numbers by the offset at which their code starts
     * @param source name of the source file
     */
    @SuppressWarnings("ArrayRecordComponent") // never compared
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

        /** {@return the source line of the instruction at an offset} */
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
