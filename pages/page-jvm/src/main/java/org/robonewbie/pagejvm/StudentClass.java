package org.robonewbie.pagejvm;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.jspecify.annotations.Nullable;

/** A class of the student's program. */
final class StudentClass {

    private final ClassFile file;
    private final Program program;
    private final Map<String, @Nullable Object> statics = new HashMap<>();
    private final Map<String, @Nullable Object> freshFields = new LinkedHashMap<>();
    private final Map<String, Optional<StudentMethod>> found = new HashMap<>();

    /** Whether the static initialiser of this class has started. */
    boolean isInitialised;

    StudentClass(ClassFile file, Program program) {
        this.file = file;
        this.program = program;
        for (ClassFile.Field field : file.fields()) {
            Object zero = field.constant().orElse(Descriptor.zero(field.descriptor()));
            (field.isStatic() ? statics : freshFields).put(field.name(), zero);
        }
    }

    ClassFile file() {
        return file;
    }

    String simpleName() {
        String name = file.name();
        return name.substring(Math.max(name.lastIndexOf('/'), name.lastIndexOf('$')) + 1);
    }

    Optional<StudentClass> parent() {
        return program.find(file.superName());
    }

    /** {@return the name of the nearest superclass that is not the student's} */
    String compiledParent() {
        return parent().map(StudentClass::compiledParent).orElse(file.superName());
    }

    /** {@return whether this class is the named type or a subtype of it} */
    boolean is(String name) {
        return file.name().equals(name)
                || file.interfaces().stream()
                        .anyMatch(one -> one.equals(name)
                                || program.find(one)
                                        .map(type -> type.is(name))
                                        .orElseGet(() -> program.compiled().isSubtype(one, name)))
                || parent().map(type -> type.is(name))
                        .orElseGet(() -> program.compiled().isSubtype(file.superName(), name));
    }

    /**
     * Finds a method in this class or its supertypes.
     *
     * @param key name and descriptor of the method
     * @return the method; empty if no class of the student declares it
     */
    Optional<StudentMethod> find(String key) {
        Optional<StudentMethod> known = found.get(key);
        if (known == null) {
            known = search(key);
            found.put(key, known);
        }
        return known;
    }

    private Optional<StudentMethod> search(String key) {
        Optional<StudentMethod> own = own(key);
        if (own.isPresent()) {
            return own;
        }
        Optional<StudentMethod> inherited = parent().flatMap(type -> type.find(key));
        if (inherited.isPresent() && !inherited.get().code().isAbstract()) {
            return inherited;
        }
        return file.interfaces().stream()
                .flatMap(name -> program.find(name).stream())
                .flatMap(type -> type.find(key).stream())
                .findFirst()
                .or(() -> inherited);
    }

    /** {@return the method of this class or its superclasses with a given name and number of parameters} */
    Optional<StudentMethod> findByName(String name, int arguments) {
        return file.methods().stream()
                .filter(method -> method.name().equals(name) && !method.isAbstract())
                .map(code -> new StudentMethod(this, code))
                .filter(method -> method.type().parameters().size() == arguments)
                .findFirst()
                .or(() -> parent().flatMap(type -> type.findByName(name, arguments)));
    }

    /** {@return the methods that this class and the student's superclasses declare, as {@code name()} or {@code name(...)}} */
    List<String> headings() {
        List<String> headings =
                new ArrayList<>(parent().map(StudentClass::headings).orElseGet(List::of));
        for (ClassFile.MethodCode method : file.methods()) {
            if (!method.name().startsWith("<") && !method.name().contains("$")) {
                boolean takesNothing =
                        Descriptor.of(method.descriptor()).parameters().isEmpty();
                headings.add(method.name() + (takesNothing ? "()" : "(...)"));
            }
        }
        return headings;
    }

    /** {@return the method with the given key, if this class declares it} */
    Optional<StudentMethod> own(String key) {
        return file.methods().stream()
                .filter(method -> method.key().equals(key))
                .findFirst()
                .map(code -> new StudentMethod(this, code));
    }

    /** {@return all static fields of the class that declares the given field; empty if that class is not the student's} */
    Optional<Map<String, @Nullable Object>> staticsWith(String field) {
        if (statics.containsKey(field)) {
            return Optional.of(statics);
        }
        for (String above : file.interfaces()) {
            Optional<Map<String, @Nullable Object>> there =
                    program.find(above).flatMap(type -> type.staticsWith(field));
            if (there.isPresent()) {
                return there;
            }
        }
        return parent().flatMap(type -> type.staticsWith(field));
    }

    /** {@return the fields of a new instance with their default values, by class and name} */
    Map<String, @Nullable Object> newFields() {
        Map<String, @Nullable Object> fields =
                parent().map(StudentClass::newFields).orElseGet(HashMap::new);
        freshFields.forEach((name, value) -> fields.put(file.name() + "." + name, value));
        return fields;
    }

    /** {@return the key of a field in instances of this class; empty if no class of the student declares it} */
    Optional<String> fieldKey(String name) {
        return freshFields.containsKey(name)
                ? Optional.of(file.name() + "." + name)
                : parent().flatMap(type -> type.fieldKey(name));
    }

    @Override
    public String toString() {
        return "class " + file.name().replace('/', '.');
    }
}
