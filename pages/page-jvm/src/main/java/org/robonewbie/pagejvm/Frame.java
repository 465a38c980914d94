package org.robonewbie.pagejvm;

import java.util.Objects;
import org.jspecify.annotations.Nullable;

/**
 * Stack frame of a student's method: program counter, local variables and operand stack. Booleans, bytes, characters and shorts are
 * represented as {@code Integer}, as in the virtual machine; a {@code long} or {@code double} takes a single stack entry.
 */
final class Frame {

    final StudentMethod method;
    final byte[] code;
    final @Nullable Object[] locals;
    private final @Nullable Object[] stack;
    private int size;

    /** Offset of the current instruction. */
    int at;

    /** Offset of the next byte to read. */
    int next;

    /** Whether the called method returns a value. */
    boolean awaitsResult;

    Frame(StudentMethod method, @Nullable Object[] arguments) {
        this.method = method;
        code = method.code().code();
        locals = new Object[method.code().locals()];
        stack = new Object[method.code().stack() + 1];
        int local = 0;
        int parameter = method.code().isStatic() ? 0 : -1;
        for (Object argument : arguments) {
            locals[local++] = argument;
            if (parameter >= 0 && Descriptor.isWide(method.type().parameters().get(parameter))) {
                local++;
            }
            parameter++;
        }
    }

    int u1() {
        return code[next++] & 0xFF;
    }

    int s1() {
        return code[next++];
    }

    int u2() {
        return u1() << 8 | u1();
    }

    int s2() {
        return s1() << 8 | u1();
    }

    int s4() {
        return u2() << 16 | u2();
    }

    /** {@return the constant at the index in the next two bytes} */
    Object constant() {
        return method.home().file().constants().get(u2());
    }

    /** Jumps relative to the current instruction. */
    void jump(int offset) {
        next = at + offset;
    }

    void push(@Nullable Object value) {
        stack[size++] = value;
    }

    @Nullable
    Object pop() {
        Object value = stack[--size];
        stack[size] = null;
        return value;
    }

    /** Pops a value, which must not be null. */
    Object popObject() {
        return Objects.requireNonNull(pop());
    }

    int popInt() {
        return (Integer) popObject();
    }

    long popLong() {
        return (Long) popObject();
    }

    float popFloat() {
        return (Float) popObject();
    }

    double popDouble() {
        return (Double) popObject();
    }

    @Nullable
    Object[] pop(int count) {
        Object[] values = new Object[count];
        for (int i = count - 1; i >= 0; i--) {
            values[i] = pop();
        }
        return values;
    }

    /** Clears the operand stack, pushes an exception and jumps to its handler. */
    void handle(Throwable mistake, int handler) {
        while (size > 0) {
            pop();
        }
        awaitsResult = false;
        push(mistake);
        next = handler;
    }

    /** Replaces a placeholder with an object in all variables and on the stack. */
    void replace(Object placeholder, Object object) {
        replace(stack, placeholder, object);
        replace(locals, placeholder, object);
    }

    private static void replace(@Nullable Object[] values, Object placeholder, Object object) {
        for (int i = 0; i < values.length; i++) {
            if (values[i] == placeholder) {
                values[i] = object;
            }
        }
    }

    StackTraceElement place() {
        return new StackTraceElement(
                method.home().file().name().replace('/', '.'),
                method.code().name(),
                method.code().source(),
                method.code().line(at));
    }
}
