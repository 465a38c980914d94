package org.robonewbie.pagejvm;

import java.util.Objects;
import org.jspecify.annotations.Nullable;
import org.robonewbie.pagejvm.ClassFile.MethodType;
import org.robonewbie.pagejvm.ClassFile.TypeName;

/** Dispatches instructions by group and executes the simple ones: constants, variables, stack operations, returns. */
final class Instructions {

    private Instructions() {}

    static void execute(Frame frame, Machine machine) {
        int code = frame.u1();
        if (code <= 20) {
            constant(code, frame, machine);
        } else if (code <= 45) {
            load(code, frame);
        } else if (code <= 53 || (code >= 79 && code <= 86)) {
            ArrayInstructions.element(code, frame);
        } else if (code <= 78) {
            store(code, frame);
        } else if (code <= 95) {
            stack(code, frame);
        } else if (code <= 152) {
            Arithmetic.execute(code, frame);
        } else if (code <= 171 || code == 198 || code == 199 || code == 200) {
            Jumping.execute(code, frame);
        } else if (code <= 177) {
            machine.leave(code == 177 ? null : frame.pop());
        } else if (code == 188 || code == 189 || code == 190 || code == 197) {
            ArrayInstructions.array(code, frame, machine.program());
        } else if (code == 196) {
            wide(frame);
        } else {
            machine.members().execute(code, frame);
        }
    }

    private static void constant(int code, Frame frame, Machine machine) {
        switch (code) {
            case 0 -> {}
            case 1 -> frame.push(null);
            case 2, 3, 4, 5, 6, 7, 8 -> frame.push(code - 3);
            case 9, 10 -> frame.push((long) (code - 9));
            case 11, 12, 13 -> frame.push((float) (code - 11));
            case 14, 15 -> frame.push((double) (code - 14));
            case 16 -> frame.push(frame.s1());
            case 17 -> frame.push(frame.s2());
            case 18 -> frame.push(loaded(frame.method.home().file().constants().get(frame.u1()), machine));
            default -> frame.push(loaded(frame.constant(), machine));
        }
    }

    private static Object loaded(Object constant, Machine machine) {
        if (constant instanceof TypeName type) {
            return machine.program()
                    .find(type.name())
                    .<Object>map(found -> found)
                    .orElseGet(() -> machine.program().compiled().type(type.name()));
        }
        if (constant instanceof MethodType) {
            throw new Missing("The program uses a method type constant");
        }
        return constant;
    }

    private static void load(int code, Frame frame) {
        frame.push(frame.locals[code <= 25 ? frame.u1() : (code - 26) % 4]);
    }

    private static void store(int code, Frame frame) {
        frame.locals[code <= 58 ? frame.u1() : (code - 59) % 4] = frame.pop();
    }

    private static void wide(Frame frame) {
        int code = frame.u1();
        int local = frame.u2();
        if (code == 132) {
            frame.locals[local] = (Integer) Objects.requireNonNull(frame.locals[local]) + frame.s2();
        } else if (code <= 25) {
            frame.push(frame.locals[local]);
        } else {
            frame.locals[local] = frame.pop();
        }
    }

    private static boolean isWide(@Nullable Object value) {
        return value instanceof Long || value instanceof Double;
    }

    private static void stack(int code, Frame frame) {
        Object top = frame.pop();
        switch (code) {
            case 87 -> {}
            case 88 -> {
                if (!isWide(top)) {
                    frame.pop();
                }
            }
            case 89 -> push(frame, top, top);
            case 90 -> {
                Object second = frame.pop();
                push(frame, top, second, top);
            }
            case 91 -> duplicateBelow(frame, top);
            case 92 -> {
                if (isWide(top)) {
                    push(frame, top, top);
                } else {
                    Object second = frame.pop();
                    push(frame, second, top, second, top);
                }
            }
            case 93, 94 -> duplicatePair(code, frame, top);
            default -> {
                Object second = frame.pop();
                push(frame, top, second);
            }
        }
    }

    /** Executes dup_x2: inserts a copy of the top value below the two stack slots under it. */
    private static void duplicateBelow(Frame frame, @Nullable Object top) {
        Object second = frame.pop();
        if (isWide(second)) {
            push(frame, top, second, top);
        } else {
            Object third = frame.pop();
            push(frame, top, third, second, top);
        }
    }

    /** Executes dup2_x1 and dup2_x2. */
    private static void duplicatePair(int code, Frame frame, @Nullable Object top) {
        Object[] pair = isWide(top) ? new Object[] {top} : new Object[] {frame.pop(), top};
        Object below = frame.pop();
        Object[] under = code == 93 || isWide(below) ? new Object[] {below} : new Object[] {frame.pop(), below};
        push(frame, pair);
        push(frame, under);
        push(frame, pair);
    }

    private static void push(Frame frame, @Nullable Object... values) {
        for (Object value : values) {
            frame.push(value);
        }
    }
}
