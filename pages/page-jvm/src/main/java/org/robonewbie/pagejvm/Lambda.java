package org.robonewbie.pagejvm;

import java.util.Objects;
import java.util.Optional;
import org.jspecify.annotations.Nullable;
import org.robonewbie.pagejvm.ClassFile.Handle;
import org.robonewbie.pagejvm.ClassFile.Member;

/** Lambda expression or method reference: a method handle and its captured arguments. */
final class Lambda {

    private static final int STATIC = 6;
    private static final int NEW = 8;

    private final String type;
    private final String name;
    private final Descriptor called;
    private final Handle handle;
    private final @Nullable Object[] remembered;
    private final Machine machine;

    /**
     * Creates a lambda.
     *
     * @param type internal name of the functional interface
     * @param name name of its abstract method
     * @param called descriptor of the call
     * @param handle the implementation
     * @param remembered captured arguments, which precede the arguments of the call
     * @param machine executes the call
     */
    Lambda(String type, String name, Descriptor called, Handle handle, @Nullable Object[] remembered, Machine machine) {
        this.type = type;
        this.name = name;
        this.called = called;
        this.handle = handle;
        this.remembered = remembered;
        this.machine = machine;
    }

    String type() {
        return type;
    }

    boolean isCalledBy(String method, Program program) {
        return method.equals(name);
    }

    /** {@return the student's method that implements the lambda; empty if a conversion is needed} */
    Optional<StudentMethod> body(Program program, @Nullable Object[] arguments) {
        Member member = handle.member();
        if (handle.kind() == NEW) {
            return Optional.empty();
        }
        if (handle.kind() == STATIC) {
            return program.find(member.owner())
                    .filter(home -> home.isInitialised)
                    .flatMap(home -> home.find(member.key()));
        }
        Object target =
                Members.with(null, remembered).length > 1 ? remembered[0] : arguments.length > 0 ? arguments[0] : null;
        return target instanceof StudentObject own
                ? own.type().find(member.key()).filter(found -> !found.code().isAbstract())
                : Optional.empty();
    }

    /** {@return all arguments for the implementation: the captured arguments, followed by those of the call} */
    @Nullable
    Object[] allArguments(StudentMethod body, @Nullable Object[] arguments) {
        Object[] all = all(arguments);
        int first = body.code().isStatic() ? 0 : 1;
        for (int i = first; i < all.length; i++) {
            all[i] = converted(all[i], body.type().parameters().get(i - first));
        }
        return all;
    }

    private @Nullable Object[] all(@Nullable Object[] arguments) {
        Object[] all = new Object[remembered.length + arguments.length];
        System.arraycopy(remembered, 0, all, 0, remembered.length);
        System.arraycopy(arguments, 0, all, remembered.length, arguments.length);
        return all;
    }

    /**
     * Calls the lambda and waits for its result.
     *
     * @param arguments arguments in the machine's representation
     * @return the result in the machine's representation
     */
    @Nullable
    Object call(@Nullable Object... arguments) {
        Member member = handle.member();
        Descriptor type = Descriptor.of(member.descriptor());
        Object[] all = all(arguments);
        if (handle.kind() == NEW) {
            return create(member, type, convertedFrom(0, all, type));
        }
        Object result;
        if (handle.kind() == STATIC) {
            machine.program().find(member.owner()).ifPresent(machine::initialiseNow);
            result = machine.members().callAndWait(member, null, convertedFrom(0, all, type));
        } else {
            Object target = Objects.requireNonNull(all[0], "null has no method " + member.name());
            Object[] others = java.util.Arrays.copyOfRange(all, 1, all.length);
            result = machine.members().callAndWait(member, target, convertedFrom(0, others, type));
        }
        return result(result, type.result(), called.result());
    }

    private Object create(Member member, Descriptor type, @Nullable Object[] arguments) {
        Optional<StudentClass> own = machine.program().find(member.owner());
        if (own.isEmpty()) {
            return machine.program().compiled().create(member, type, arguments, machine);
        }
        machine.initialiseNow(own.get());
        StudentObject object = StudentObjects.create(own.get(), machine);
        StudentMethod constructor =
                own.get().own(member.key()).orElseThrow(() -> new Missing(own.get() + " has no such constructor"));
        machine.call(constructor, Members.with(object, arguments));
        return object;
    }

    private static @Nullable Object[] convertedFrom(int first, @Nullable Object[] values, Descriptor type) {
        Object[] converted = values.clone();
        for (int i = first; i < values.length; i++) {
            converted[i] = converted(values[i], type.parameters().get(i));
        }
        return converted;
    }

    private static @Nullable Object converted(@Nullable Object value, String type) {
        if (type.length() > 1 || value == null) {
            return value;
        }
        Object kept = Compiled.fromJava(value);
        return switch (type) {
            case "D" -> ((Number) Objects.requireNonNull(kept)).doubleValue();
            case "F" -> ((Number) Objects.requireNonNull(kept)).floatValue();
            case "J" -> ((Number) Objects.requireNonNull(kept)).longValue();
            default -> kept;
        };
    }

    private static @Nullable Object result(@Nullable Object value, String made, String wanted) {
        if (wanted.length() == 1) {
            return wanted.equals("V") ? null : converted(value, wanted);
        }
        if (!(value instanceof Integer number)) {
            return value;
        }
        return switch (made) {
            case "Z" -> number != 0;
            case "C" -> (Object) (char) (int) number;
            case "B" -> (Object) (byte) (int) number;
            case "S" -> (Object) (short) (int) number;
            default -> value;
        };
    }
}
