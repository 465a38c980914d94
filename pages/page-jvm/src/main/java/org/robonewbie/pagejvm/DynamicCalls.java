package org.robonewbie.pagejvm;

import java.util.List;
import java.util.Objects;
import org.jspecify.annotations.Nullable;
import org.robonewbie.pagejvm.ClassFile.Bootstrap;
import org.robonewbie.pagejvm.ClassFile.DynamicCall;
import org.robonewbie.pagejvm.ClassFile.Handle;
import org.robonewbie.pagejvm.ClassFile.MethodType;

/** The {@code invokedynamic} calls of Java 17: lambdas, string concatenation, and the generated methods of records. */
final class DynamicCalls {

    private static final char ARGUMENT = '\u0001';
    private static final char CONSTANT = '\u0002';
    private static final int INSTANTIATED_TYPE = 2;

    private final Machine machine;

    DynamicCalls(Machine machine) {
        this.machine = machine;
    }

    @Nullable
    Object answer(DynamicCall call, Descriptor type, StudentClass home, @Nullable Object[] arguments) {
        Bootstrap bootstrap = home.file().bootstraps().get(call.bootstrap());
        String linker = bootstrap.handle().member().owner();
        return switch (linker) {
            case "java/lang/invoke/LambdaMetafactory" -> lambda(call, type, bootstrap.arguments(), arguments);
            case "java/lang/invoke/StringConcatFactory" -> text(type, bootstrap.arguments(), arguments);
            case "java/lang/runtime/ObjectMethods" -> ofRecord(call.name(), bootstrap.arguments(), arguments);
            default -> throw new Missing("The program uses an unsupported bootstrap method of " + linker.replace('/', '.'));
        };
    }

    private Lambda lambda(DynamicCall call, Descriptor type, List<Object> constants, @Nullable Object[] remembered) {
        String result = type.result();
        return new Lambda(
                result.substring(1, result.length() - 1),
                call.name(),
                Descriptor.of(((MethodType) constants.get(INSTANTIATED_TYPE)).descriptor()),
                (Handle) constants.get(1),
                remembered,
                machine);
    }

    private static String text(Descriptor type, List<Object> constants, @Nullable Object[] arguments) {
        StringBuilder text = new StringBuilder();
        int argument = 0;
        int constant = 1;
        for (char character : ((String) constants.get(0)).toCharArray()) {
            if (character == ARGUMENT) {
                text.append(text(arguments[argument], type.parameters().get(argument)));
                argument++;
            } else if (character == CONSTANT) {
                text.append(constants.get(constant++));
            } else {
                text.append(character);
            }
        }
        return text.toString();
    }

    private static String text(@Nullable Object value, String type) {
        return switch (type) {
            case "Z" -> String.valueOf(Integer.valueOf(1).equals(value));
            case "C" -> String.valueOf((char) (int) (Integer) Objects.requireNonNull(value));
            default -> String.valueOf(value);
        };
    }

    /** Calls equals, hashCode or toString of a record; the constants are its class, the component names and the component getters. */
    private Object ofRecord(String name, List<Object> constants, @Nullable Object[] arguments) {
        StudentObject one = (StudentObject) Objects.requireNonNull(arguments[0]);
        String[] names = constants.get(1).toString().split(";", -1);
        int parts = constants.size() - 2;
        if (name.equals("equals")) {
            boolean isEqual = arguments[1] instanceof StudentObject other && other.type() == one.type();
            for (int i = 0; isEqual && i < parts; i++) {
                isEqual = Objects.equals(
                        part(one, constants, i),
                        part((StudentObject) Objects.requireNonNull(arguments[1]), constants, i));
            }
            return isEqual ? 1 : 0;
        }
        StringBuilder text = new StringBuilder(one.type().simpleName()).append('[');
        int hash = 0;
        for (int i = 0; i < parts; i++) {
            Object part = part(one, constants, i);
            hash = 31 * hash + Objects.hashCode(part);
            text.append(i == 0 ? "" : ", ").append(names[i]).append('=').append(text(part, type(constants, i)));
        }
        return name.equals("hashCode") ? (Object) hash : text.append(']').toString();
    }

    private static @Nullable Object part(StudentObject object, List<Object> constants, int index) {
        Handle reader = (Handle) constants.get(index + 2);
        return object.fields()
                .get(reader.member().owner() + "." + reader.member().name());
    }

    private static String type(List<Object> constants, int index) {
        return ((Handle) constants.get(index + 2)).member().descriptor();
    }
}
