package org.robonewbie.pagejvm;

import java.util.Map;
import org.jspecify.annotations.Nullable;

/** Instance of a student's exception class. */
final class StudentException extends RuntimeException implements StudentObject {

    private static final long serialVersionUID = 1;

    private final transient StudentClass type;
    private final transient Machine machine;
    private final transient Map<String, @Nullable Object> fields;
    private @Nullable String message;

    StudentException(StudentClass type, Machine machine) {
        this.type = type;
        this.machine = machine;
        fields = type.newFields();
    }

    @Override
    public StudentClass type() {
        return type;
    }

    @Override
    public Machine machine() {
        return machine;
    }

    @Override
    public Map<String, @Nullable Object> fields() {
        return fields;
    }

    @Override
    public @Nullable Object callSuper(ClassFile.Member member, @Nullable Object[] arguments) {
        switch (member.name()) {
            case "<init>" -> initialise(arguments);
            case "getMessage", "getLocalizedMessage" -> {
                return message;
            }
            case "toString" -> {
                return defaultText();
            }
            default -> throw new Missing("super." + member.name() + "() is not available");
        }
        return null;
    }

    private void initialise(@Nullable Object[] arguments) {
        for (Object argument : arguments) {
            if (argument instanceof Throwable cause) {
                initCause(cause);
                message = message == null ? cause.toString() : message;
            } else if (argument instanceof String text) {
                message = text;
            }
        }
    }

    @Override
    public @Nullable String getMessage() {
        return type.find("getMessage()Ljava/lang/String;")
                .map(method -> String.valueOf(machine.call(method, this)))
                .orElse(message);
    }

    private String defaultText() {
        String name = type.file().name().replace('/', '.');
        String text = getMessage();
        return text == null ? name : name + ": " + text;
    }

    @Override
    public String toString() {
        return type.find("toString()Ljava/lang/String;")
                .map(method -> String.valueOf(machine.call(method, this)))
                .orElseGet(this::defaultText);
    }
}
