package org.robonewbie.pagejvm;

import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import org.jspecify.annotations.Nullable;

/** Instance of a student's plain class, record or enumeration. */
@SuppressWarnings("ComparableType") // only enumeration constants are comparable
final class StudentInstance implements StudentObject, Comparable<Object> {

    private final StudentClass type;
    private final Machine machine;
    private final Map<String, @Nullable Object> fields;
    private String name = "";
    private int ordinal;

    StudentInstance(StudentClass type, Machine machine) {
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

    /** {@return the name of the enumeration constant} */
    String name() {
        return name;
    }

    /** {@return the ordinal of the enumeration constant} */
    int ordinal() {
        return ordinal;
    }

    @Override
    public @Nullable Object callSuper(ClassFile.Member member, @Nullable Object[] arguments) {
        if (member.name().equals("<init>")) {
            if (arguments.length == 2) { // enumeration constant
                name = (String) Objects.requireNonNull(arguments[0]);
                ordinal = (Integer) Objects.requireNonNull(arguments[1]);
            }
            return null;
        }
        return switch (member.name()) {
            case "toString" -> defaultText();
            case "hashCode" -> System.identityHashCode(this);
            case "equals" -> arguments[0] == this ? 1 : 0;
            default -> throw new Missing("super." + member.name() + "() is not available");
        };
    }

    private String defaultText() {
        return name.isEmpty()
                ? type.file().name().replace('/', '.') + "@" + Integer.toHexString(System.identityHashCode(this))
                : name;
    }

    private Optional<StudentMethod> own(String key) {
        return type.find(key).filter(method -> !method.code().isAbstract());
    }

    @Override
    public String toString() {
        return own("toString()Ljava/lang/String;")
                .map(method -> String.valueOf(machine.call(method, this)))
                .orElseGet(this::defaultText);
    }

    @Override
    public boolean equals(@Nullable Object other) {
        return own("equals(Ljava/lang/Object;)Z")
                .map(method -> Integer.valueOf(1).equals(machine.call(method, this, other)))
                .orElse(this == other);
    }

    @Override
    public int hashCode() {
        return own("hashCode()I")
                .map(method -> (Integer) Objects.requireNonNull(machine.call(method, this)))
                .orElseGet(() -> System.identityHashCode(this));
    }

    @Override
    public int compareTo(Object other) {
        Optional<StudentMethod> own = own("compareTo(Ljava/lang/Object;)I");
        if (own.isPresent()) {
            return (Integer) Objects.requireNonNull(machine.call(own.get(), this, other));
        }
        if (name.isEmpty()) {
            throw new ClassCastException(type + " does not implement Comparable");
        }
        return Integer.compare(ordinal, ((StudentInstance) other).ordinal);
    }
}
