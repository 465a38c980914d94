package org.robonewbie.pagejvm;

import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import org.jspecify.annotations.Nullable;
import org.robonewbie.pagejvm.ClassFile.DynamicCall;
import org.robonewbie.pagejvm.ClassFile.Member;
import org.robonewbie.pagejvm.ClassFile.TypeName;

/** Instructions for fields, calls and types. They connect the student's classes with the compiled ones. */
final class Members {

    private static final String CONSTRUCTOR = "<init>";

    private final Machine machine;
    private final Program program;
    private final DynamicCalls dynamicCalls;

    Members(Machine machine) {
        this.machine = machine;
        program = machine.program();
        dynamicCalls = new DynamicCalls(machine);
    }

    void execute(int code, Frame frame) {
        switch (code) {
            case 178, 179 -> staticField(code, frame, (Member) frame.constant());
            case 180 -> frame.push(read(frame, (Member) frame.constant()));
            case 181 -> write(frame, (Member) frame.constant());
            case 182, 185 -> callVirtual(code, frame);
            case 183 -> callSpecial(frame, (Member) frame.constant());
            case 184 -> callStatic(frame, (Member) frame.constant());
            case 186 -> dynamicCall(frame);
            case 187 -> create(frame, ((TypeName) frame.constant()).name());
            case 191 -> throw new Machine.Thrown((Throwable) Objects.requireNonNull(frame.pop(), "throw null"));
            case 192 -> cast(frame, ((TypeName) frame.constant()).name());
            case 193 -> {
                String type = ((TypeName) frame.constant()).name();
                Object value = frame.pop();
                frame.push(value != null && StudentObjects.isInstance(value, type, program) ? 1 : 0);
            }
            case 194, 195 -> Objects.requireNonNull(frame.pop());
            default -> throw new Missing("The instruction " + code + " is not part of Java 17");
        }
    }

    /**
     * Starts a class's static initialiser if it has not run yet. Returns true in that case; the instruction is repeated later.
     */
    private boolean mustWaitForInitialiser(Frame frame, StudentClass type) {
        if (!machine.initialise(type)) {
            return false;
        }
        frame.next = frame.at;
        return true;
    }

    private void staticField(int code, Frame frame, Member field) {
        Optional<StudentClass> owner = program.find(field.owner());
        if (owner.isPresent() && mustWaitForInitialiser(frame, owner.get())) {
            return;
        }
        Optional<Map<String, @Nullable Object>> statics = owner.flatMap(type -> type.staticsWith(field.name()));
        if (statics.isPresent() && code == 179) {
            statics.get().put(field.name(), frame.pop());
        } else if (statics.isPresent()) {
            frame.push(statics.get().get(field.name()));
        } else {
            frame.push(compiledStatic(field));
        }
    }

    private @Nullable Object compiledStatic(Member field) {
        boolean isOutput = field.owner().equals("java/lang/System")
                && (field.name().equals("out") || field.name().equals("err"));
        return isOutput ? machine.output() : program.compiled().staticField(field);
    }

    private @Nullable Object read(Frame frame, Member field) {
        Object object = Objects.requireNonNull(frame.pop(), () -> "Cannot read \"" + field.name() + "\" of null");
        if (object instanceof StudentObject own) {
            Optional<String> key = own.type().fieldKey(field.name());
            Optional<StudentClass> owner = program.find(field.owner());
            if (owner.isPresent()) {
                key = owner.get().fieldKey(field.name());
            }
            return key.isPresent() ? own.fields().get(key.get()) : own.inheritedField(field.name());
        }
        return program.compiled().field(field, object);
    }

    private void write(Frame frame, Member field) {
        Object value = frame.pop();
        Object object = Objects.requireNonNull(frame.pop(), () -> "Cannot set \"" + field.name() + "\" of null");
        if (!(object instanceof StudentObject own)) {
            throw new Missing("The field " + field.name() + " of " + field.owner() + " cannot be set");
        }
        String key = program.find(field.owner())
                .flatMap(type -> type.fieldKey(field.name()))
                .orElseThrow(() -> new Missing("There is no field " + field.name()));
        own.fields().put(key, value);
    }

    private void callVirtual(int code, Frame frame) {
        Member method = (Member) frame.constant();
        if (code == 185) {
            frame.u2(); // argument count and a zero byte
        }
        Descriptor type = Descriptor.of(method.descriptor());
        Object[] arguments = frame.pop(type.parameters().size());
        Object target = Objects.requireNonNull(
                frame.pop(), () -> "Cannot call \"" + method.name() + "()\" because the value before the dot is null");
        call(frame, method, type, target, arguments);
    }

    /**
     * Calls a method on an object: the student's implementation if there is one, otherwise that of a compiled class.
     */
    private void call(Frame frame, Member method, Descriptor type, Object target, @Nullable Object[] arguments) {
        if (target instanceof Lambda lambda && lambda.isCalledBy(method.name(), program)) {
            enterLambda(frame, lambda, type, arguments);
            return;
        }
        Optional<StudentMethod> own = ownMethod(target, method);
        if (own.isPresent()) {
            enter(frame, own.get(), with(target, arguments));
        } else {
            answer(frame, type, callCompiled(method, type, target, arguments));
        }
    }

    private Optional<StudentMethod> ownMethod(Object target, Member method) {
        Optional<StudentClass> home = target instanceof StudentObject own
                ? Optional.of(own.type())
                : target instanceof Lambda lambda ? program.find(lambda.type()) : Optional.empty();
        return home.flatMap(type -> type.find(method.key()))
                .filter(found -> !found.code().isAbstract());
    }

    private @Nullable Object callCompiled(Member method, Descriptor type, Object target, @Nullable Object[] arguments) {
        Object special = machine.specialCalls().call(method.owner(), method.name(), target, arguments);
        if (special != SpecialCalls.UNKNOWN) {
            return special;
        }
        Object known = StudentObjects.callOfEachObject(method, target, arguments, machine);
        if (known != SpecialCalls.UNKNOWN) {
            return known;
        }
        return program.compiled().call(method, type, target, arguments, machine);
    }

    private void callSpecial(Frame frame, Member method) {
        Descriptor type = Descriptor.of(method.descriptor());
        Object[] arguments = frame.pop(type.parameters().size());
        Object target = frame.popObject();
        Optional<StudentMethod> found = program.find(method.owner())
                .flatMap(owner ->
                        method.name().equals(CONSTRUCTOR) ? owner.own(method.key()) : owner.find(method.key()));
        if (found.isPresent()) {
            enter(frame, found.get(), with(target, arguments));
        } else if (target instanceof StudentObject own) {
            answer(frame, type, own.callSuper(method, arguments));
        } else if (method.name().equals(CONSTRUCTOR)) {
            Object object = program.compiled().create(method, type, arguments, machine);
            if (object instanceof Throwable mistake) {
                machine.trace(mistake);
            }
            frame.replace(target, object);
        } else {
            answer(frame, type, callCompiled(method, type, target, arguments));
        }
    }

    private void callStatic(Frame frame, Member method) {
        Optional<StudentClass> owner = program.find(method.owner());
        if (owner.isPresent() && mustWaitForInitialiser(frame, owner.get())) {
            return;
        }
        Descriptor type = Descriptor.of(method.descriptor());
        Object[] arguments = frame.pop(type.parameters().size());
        Optional<StudentMethod> found = owner.flatMap(home -> home.find(method.key()));
        if (found.isPresent()) {
            enter(frame, found.get(), arguments);
            return;
        }
        Object special = machine.specialCalls().call(method.owner(), method.name(), null, arguments);
        if (special == SpecialCalls.UNKNOWN) {
            special = StudentObjects.staticCall(method, owner.orElse(null), arguments, machine);
        }
        answer(
                frame,
                type,
                special == SpecialCalls.UNKNOWN
                        ? program.compiled().call(method, type, null, arguments, machine)
                        : special);
    }

    private void dynamicCall(Frame frame) {
        DynamicCall call = (DynamicCall) frame.constant();
        frame.u2(); // always zero
        Descriptor type = Descriptor.of(call.descriptor());
        frame.push(dynamicCalls.answer(
                call, type, frame.method.home(), frame.pop(type.parameters().size())));
    }

    private void create(Frame frame, String type) {
        Optional<StudentClass> own = program.find(type);
        if (own.isEmpty()) {
            frame.push(new Uninitialised());
        } else if (!mustWaitForInitialiser(frame, own.get())) {
            frame.push(StudentObjects.create(own.get(), machine));
        }
    }

    private void cast(Frame frame, String type) {
        Object value = frame.pop();
        if (value != null && !StudentObjects.isInstance(value, type, program)) {
            throw new ClassCastException(
                    "A " + StudentObjects.className(value) + " is not a " + type.replace('/', '.'));
        }
        frame.push(value);
    }

    private void enter(Frame frame, StudentMethod method, @Nullable Object[] arguments) {
        machine.enter(method, arguments);
        frame.awaitsResult = !method.type().result().equals("V");
    }

    private void enterLambda(Frame frame, Lambda lambda, Descriptor type, @Nullable Object[] arguments) {
        Optional<StudentMethod> body = lambda.body(program, arguments);
        boolean isSimple = body.isPresent()
                && body.get().type().result().length() == type.result().length();
        if (isSimple) {
            enter(frame, body.get(), lambda.allArguments(body.get(), arguments));
        } else {
            answer(frame, type, lambda.call(arguments));
        }
    }

    private void answer(Frame frame, Descriptor type, @Nullable Object value) {
        boolean isWanted = !type.result().equals("V");
        if (value instanceof Waiting pause) {
            machine.await(pause, isWanted);
        } else if (isWanted) {
            frame.push(type.result().length() == 1 ? Compiled.fromJava(value) : value);
        }
    }

    static @Nullable Object[] with(@Nullable Object first, @Nullable Object[] others) {
        Object[] all = new Object[others.length + 1];
        all[0] = first;
        System.arraycopy(others, 0, all, 1, others.length);
        return all;
    }

    /**
     * Calls a method for the machine itself rather than for an instruction of the program, and waits for the result.
     */
    @Nullable
    Object callAndWait(Member method, @Nullable Object target, @Nullable Object[] arguments) {
        Descriptor type = Descriptor.of(method.descriptor());
        Optional<StudentClass> owner = program.find(method.owner());
        if (target == null) {
            Optional<StudentMethod> found = owner.flatMap(home -> home.find(method.key()));
            return found.isPresent()
                    ? machine.call(found.get(), arguments)
                    : program.compiled().call(method, type, null, arguments, machine);
        }
        if (target instanceof Lambda lambda && lambda.isCalledBy(method.name(), program)) {
            return lambda.call(arguments);
        }
        Optional<StudentMethod> own = ownMethod(target, method);
        return own.isPresent()
                ? machine.call(own.get(), with(target, arguments))
                : callCompiled(method, type, target, arguments);
    }

    /** Placeholder for an object of a compiled class until its constructor has been called. */
    private static final class Uninitialised {}
}
