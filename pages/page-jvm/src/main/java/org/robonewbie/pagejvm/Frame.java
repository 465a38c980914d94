package org.robonewbie.pagejvm;

import java.util.Objects;
import org.jspecify.annotations.Nullable;

/**
 * One call of a method of the student: where it is, its variables and what it has laid down. Truth values, bytes, characters and shorts
 * are kept as {@code Integer}, as in the virtual machine; a {@code long} and a {@code double} take one place of the stack.
 */
final class Frame {

    final StudentMethod method;
    final byte[] code;
    final @Nullable Object[] locals;
    private final @Nullable Object[] stack;
    private int size;

    /** The first byte of the instruction that is carried out. */
    int at;

    /** The next byte to read. */
    int next;

    /** Whether the method that it has called gives it a result. */
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

    /** {@return the constant that the next two bytes name} */
    Object constant() {
        return method.home().file().constants().get(u2());
    }

    /** Goes on elsewhere. */
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

    /** {@return the value on top, where the program lays down an object} */
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

    /** Forgets what was laid down, and lays down an exception for its handler. */
    void handle(Throwable mistake, int handler) {
        while (size > 0) {
            pop();
        }
        awaitsResult = false;
        push(mistake);
        next = handler;
    }

    /** Puts an object wherever its announcement stands. */
    void replace(Object announcement, Object object) {
        replace(stack, announcement, object);
        replace(locals, announcement, object);
    }

    private static void replace(@Nullable Object[] values, Object announcement, Object object) {
        for (int i = 0; i < values.length; i++) {
            if (values[i] == announcement) {
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
