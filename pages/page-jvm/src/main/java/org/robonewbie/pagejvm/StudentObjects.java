package org.robonewbie.pagejvm;

import java.util.Objects;
import java.util.Set;
import org.jspecify.annotations.Nullable;
import org.robonewbie.pagejvm.ClassFile.Member;

/** Creates instances of the student's classes and implements the methods that all objects have. */
final class StudentObjects {

    private static final String AGENT = "org/robonewbie/agent/Agent";
    private static final Set<String> PLAIN = Set.of("java/lang/Object", "java/lang/Record", "java/lang/Enum");

    private StudentObjects() {}

    /**
     * Checks that the page can create instances of a class.
     *
     * @param type the class
     * @throws IllegalArgumentException if it extends a class that the page does not support; the message is shown to the user
     */
    static void check(StudentClass type) {
        String above = type.compiledParent();
        if (!PLAIN.contains(above) && !above.equals(AGENT) && !isThrowable(type)) {
            throw new IllegalArgumentException(type.simpleName() + " extends " + above.replace('/', '.')
                    + ", which this page does not support; RoboNewbie on your computer does. On this page, a class may extend Agent, an"
                    + " exception, or one of your own classes.");
        }
    }

    private static boolean isThrowable(StudentClass type) {
        return type.is("java/lang/Throwable");
    }

    static StudentObject create(StudentClass type, Machine machine) {
        String above = type.compiledParent();
        if (above.equals(AGENT)) {
            return new StudentAgent(type, machine);
        }
        if (PLAIN.contains(above)) {
            return new StudentInstance(type, machine);
        }
        StudentException mistake = new StudentException(type, machine);
        machine.trace(mistake);
        return mistake;
    }

    /** {@return whether an object is an instance of the class with the given internal name} */
    static boolean isInstance(Object value, String name, Program program) {
        if (name.equals("java/lang/Object")) {
            return true;
        }
        if (value instanceof StudentObject own) {
            return own.type().is(name);
        }
        if (value instanceof Lambda lambda) {
            return lambda.type().equals(name)
                    || program.find(lambda.type())
                            .map(type -> type.is(name))
                            .orElseGet(() -> program.compiled().isSubtype(lambda.type(), name));
        }
        if (value instanceof StudentClass) {
            return name.equals("java/lang/Class");
        }
        if (name.startsWith("[")) {
            return ArrayCopy.isOfNumbers(name)
                    ? ArrayCopy.isArray(value, name)
                    : program.compiled().javaType(name).isInstance(value);
        }
        return program.find(name).isEmpty() && program.compiled().type(name).isInstance(value);
    }

    /** {@return the class name of an object, for use in messages} */
    static String className(Object value) {
        return value instanceof StudentObject own
                ? own.type().simpleName()
                : value.getClass().getSimpleName();
    }

    /** Calls methods that have no bytecode: those of arrays, enumerations, class objects and agents. */
    static @Nullable Object callOfEachObject(
            Member method, Object target, @Nullable Object[] arguments, Machine machine) {
        if (target instanceof StudentAgent agent) {
            Object answer = agent.inherited(method.name(), arguments);
            if (answer != SpecialCalls.UNKNOWN) {
                return answer;
            }
        }
        if (target instanceof StudentInstance instance
                && instance.type().compiledParent().equals("java/lang/Enum")) {
            Object answer = ofEnumeration(method.name(), instance);
            if (answer != SpecialCalls.UNKNOWN) {
                return answer;
            }
        }
        if (target instanceof StudentClass type) {
            return ofClass(method.name(), type);
        }
        return switch (method.name()) {
            case "getClass" -> target instanceof StudentObject own ? own.type() : (Object) target.getClass();
            case "clone" -> target.getClass().isArray() ? copy(target) : SpecialCalls.UNKNOWN;
            case "desiredAssertionStatus" -> 0;
            case "printStackTrace" -> {
                machine.output().println(text((Throwable) target));
                yield null;
            }
            default -> SpecialCalls.UNKNOWN;
        };
    }

    private static String text(Throwable mistake) {
        StringBuilder text = new StringBuilder(mistake.toString());
        for (StackTraceElement call : mistake.getStackTrace()) {
            text.append("\n    at ").append(call);
        }
        return text.toString();
    }

    private static @Nullable Object ofEnumeration(String method, StudentInstance one) {
        return switch (method) {
            case "name" -> one.name();
            case "ordinal" -> one.ordinal();
            case "getDeclaringClass" -> one.type();
            default -> SpecialCalls.UNKNOWN;
        };
    }

    private static Object ofClass(String method, StudentClass type) {
        return switch (method) {
            case "getSimpleName" -> type.simpleName();
            case "getName" -> type.file().name().replace('/', '.');
            case "desiredAssertionStatus" -> 0;
            case "toString" -> type.toString();
            case "hashCode" -> type.hashCode();
            default -> throw new Missing("Class." + method + "() is not available for a class of the program");
        };
    }

    private static Object copy(Object array) {
        int length = java.lang.reflect.Array.getLength(array);
        Object copy = java.lang.reflect.Array.newInstance(
                Objects.requireNonNull(array.getClass().getComponentType()), length);
        ArrayCopy.copy(array, 0, copy, 0, length);
        return copy;
    }

    /** Calls {@code Enum.valueOf} for an enum defined by a student. */
    static @Nullable Object staticCall(
            Member method, @Nullable StudentClass owner, @Nullable Object[] arguments, Machine machine) {
        boolean isValueOf = method.name().equals("valueOf") && arguments.length == 2;
        if (!isValueOf || !(arguments[0] instanceof StudentClass type)) {
            return SpecialCalls.UNKNOWN;
        }
        StudentMethod values = type.own("values()[L" + type.file().name() + ";")
                .orElseThrow(() -> new Missing(type + " is not an enum"));
        for (Object one : (Object[]) Objects.requireNonNull(machine.call(values))) {
            if (((StudentInstance) one).name().equals(arguments[1])) {
                return one;
            }
        }
        throw new IllegalArgumentException("No enum constant " + type.simpleName() + "." + arguments[1]);
    }
}
