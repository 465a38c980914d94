package org.robonewbie.pagejvm;

import java.lang.reflect.Array;
import java.lang.reflect.Constructor;
import java.lang.reflect.Executable;
import java.lang.reflect.InvocationTargetException;
import java.lang.reflect.Method;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.Set;
import org.jspecify.annotations.Nullable;
import org.robonewbie.pagejvm.ClassFile.Member;

/** Reflective access to the compiled classes: the framework and the Java library. */
final class Compiled {

    /** Classes with methods that the machine executes itself. */
    private static final Set<String> SPECIAL = Set.of(
            "org/robonewbie/agent/Agent",
            "org/robonewbie/agent/Nao",
            "java/lang/System",
            "java/lang/Math",
            "java/lang/StrictMath",
            "java/lang/Enum",
            "java/lang/Object",
            "java/lang/Class",
            "java/lang/Record");

    private final Map<Member, Optional<Method>> methods = new HashMap<>();
    private final Map<Member, Optional<Constructor<?>>> constructors = new HashMap<>();
    private final Map<String, Class<?>> types = new HashMap<>();
    private final Set<String> initialised = new HashSet<>();

    /** {@return the class for an internal name or an array descriptor} */
    Class<?> type(String name) {
        return known(name).orElseThrow(() -> new Missing("The class " + name.replace('/', '.') + " is not available"));
    }

    private Optional<Class<?>> known(String name) {
        Class<?> known = types.get(name);
        if (known == null) {
            known = name.startsWith("[") ? javaType(name) : find(name);
            if (known != null) {
                types.put(name, known);
            }
        }
        return Optional.ofNullable(known);
    }

    private static @Nullable Class<?> find(String name) {
        try {
            return Class.forName(name.replace('/', '.'), false, Compiled.class.getClassLoader());
        } catch (ClassNotFoundException missing) {
            return null;
        }
    }

    /** {@return the class for a descriptor; {@code Object} for a student's class} */
    Class<?> javaType(String descriptor) {
        return switch (descriptor.charAt(0)) {
            case 'Z' -> boolean.class;
            case 'B' -> byte.class;
            case 'C' -> char.class;
            case 'S' -> short.class;
            case 'I' -> int.class;
            case 'J' -> long.class;
            case 'F' -> float.class;
            case 'D' -> double.class;
            case '[' -> Array.newInstance(javaType(descriptor.substring(1)), 0).getClass();
            default -> known(descriptor.substring(1, descriptor.length() - 1)).orElse(Object.class);
        };
    }

    /** {@return whether a compiled class is a subtype of another; both are given by their internal names} */
    boolean isSubtype(String name, String above) {
        Optional<Class<?>> lower = known(name);
        Optional<Class<?>> upper = known(above);
        return lower.isPresent() && upper.isPresent() && upper.get().isAssignableFrom(lower.get());
    }

    /** {@return whether there is a class with the given internal name} */
    boolean isKnown(String name) {
        return known(name).isPresent();
    }

    /** {@return whether a field or method exists, as far as this can be determined before the program runs} */
    boolean has(Member member) {
        if (!isKnown(member.owner())) {
            return false;
        }
        boolean isSpecial = SPECIAL.contains(member.owner());
        if (isSpecial || !member.descriptor().startsWith("(")) {
            return true;
        }
        Descriptor type = Descriptor.of(member.descriptor());
        return member.name().equals("<init>")
                ? findConstructor(member, type).isPresent()
                : findMethod(member, type).isPresent();
    }

    @Nullable
    Object staticField(Member field) {
        initialise(field.owner());
        return field(field, null);
    }

    /** Initialises a class explicitly, because reflective field access does not do so in a page. */
    private void initialise(String name) {
        if (initialised.add(name)) {
            try {
                Class.forName(type(name).getName(), true, Compiled.class.getClassLoader());
            } catch (ClassNotFoundException missing) {
                throw new Missing("The class " + name.replace('/', '.') + " is not available");
            }
        }
    }

    @Nullable
    Object field(Member field, @Nullable Object object) {
        try {
            Object value = type(field.owner()).getField(field.name()).get(object);
            return field.descriptor().length() == 1 ? fromJava(value) : value;
        } catch (ReflectiveOperationException missing) {
            throw new Missing(
                    "The field " + field.name() + " of " + field.owner().replace('/', '.') + " is not available");
        }
    }

    @Nullable
    Object call(
            Member member, Descriptor type, @Nullable Object target, @Nullable Object[] arguments, Machine machine) {
        Method method = methods.computeIfAbsent(member, wanted -> findMethod(wanted, type))
                .orElseThrow(() -> missing(member));
        Object object = Bridges.adapted(target, method.getDeclaringClass(), machine);
        try {
            return method.invoke(object, forJava(method, arguments, machine));
        } catch (InvocationTargetException failed) {
            throw unwrapped(failed);
        } catch (IllegalAccessException hidden) {
            throw missing(member);
        }
    }

    /** Creates an instance of a compiled class. */
    Object create(Member member, Descriptor type, @Nullable Object[] arguments, Machine machine) {
        Constructor<?> constructor = constructors
                .computeIfAbsent(member, wanted -> findConstructor(wanted, type))
                .orElseThrow(() -> missing(member));
        try {
            return constructor.newInstance(forJava(constructor, arguments, machine));
        } catch (InvocationTargetException failed) {
            throw unwrapped(failed);
        } catch (IllegalAccessException | InstantiationException hidden) {
            throw missing(member);
        }
    }

    private static Missing missing(Member member) {
        return new Missing(member.owner().replace('/', '.') + "." + member.name() + " is not available");
    }

    private static RuntimeException unwrapped(InvocationTargetException failed) {
        Throwable cause = Objects.requireNonNullElse(failed.getCause(), failed);
        if (cause instanceof Error error) {
            throw error;
        }
        return cause instanceof RuntimeException mistake ? mistake : new Machine.Thrown(cause);
    }

    private Optional<Method> findMethod(Member member, Descriptor type) {
        List<Class<?>> parameters = parameters(type);
        Class<?> result = type.result().equals("V") ? void.class : javaType(type.result());
        Method best = null;
        for (Class<?> owner : withAbove(type(member.owner()))) {
            for (Method method : owner.getDeclaredMethods()) {
                boolean fits = method.getName().equals(member.name())
                        && List.of(method.getParameterTypes()).equals(parameters);
                if (fits && (best == null || (method.getReturnType() == result && best.getReturnType() != result))) {
                    best = method;
                }
            }
        }
        return Optional.ofNullable(best);
    }

    private Optional<Constructor<?>> findConstructor(Member member, Descriptor type) {
        List<Class<?>> parameters = parameters(type);
        for (Constructor<?> constructor : type(member.owner()).getDeclaredConstructors()) {
            if (List.of(constructor.getParameterTypes()).equals(parameters)) {
                return Optional.of(constructor);
            }
        }
        return Optional.empty();
    }

    private List<Class<?>> parameters(Descriptor type) {
        List<Class<?>> parameters = new ArrayList<>();
        type.parameters().forEach(parameter -> parameters.add(javaType(parameter)));
        return parameters;
    }

    /** Returns a class and all its supertypes, which include {@code Object} for an interface. */
    private static List<Class<?>> withAbove(Class<?> type) {
        List<Class<?>> all = new ArrayList<>(List.of(type));
        for (int i = 0; i < all.size(); i++) {
            Class<?> one = all.get(i);
            if (one.getSuperclass() != null) {
                all.add(one.getSuperclass());
            }
            all.addAll(List.of(one.getInterfaces()));
        }
        if (type.isInterface()) {
            all.add(Object.class);
        }
        return all;
    }

    private static @Nullable Object[] forJava(Executable method, @Nullable Object[] arguments, Machine machine) {
        Class<?>[] types = method.getParameterTypes();
        Object[] adapted = new Object[arguments.length];
        for (int i = 0; i < arguments.length; i++) {
            if (isOfNumbers(types[i])) {
                throw new Missing(method.getName() + " with an array of numbers or characters is not available");
            }
            adapted[i] = toJava(arguments[i], types[i], machine);
        }
        return adapted;
    }

    /** {@return whether a type is an array of primitives, possibly nested} */
    private static boolean isOfNumbers(Class<?> type) {
        Class<?> inner = type.getComponentType();
        return inner != null && (inner.isPrimitive() || isOfNumbers(inner));
    }

    /** {@return a value, converted from the machine's representation to that of compiled code} */
    static @Nullable Object toJava(@Nullable Object value, Class<?> type, Machine machine) {
        if (!type.isPrimitive()) {
            return Bridges.adapted(value, type, machine);
        }
        if (!(value instanceof Integer number)) {
            return value;
        }
        if (type == boolean.class) {
            return number != 0;
        }
        if (type == char.class) {
            return (char) (int) number;
        }
        if (type == byte.class) {
            return (byte) (int) number;
        }
        return type == short.class ? (Object) (short) (int) number : number;
    }

    /** {@return a value from compiled code, converted to the machine's representation} */
    static @Nullable Object fromJava(@Nullable Object value) {
        if (value instanceof Boolean truth) {
            return truth ? 1 : 0;
        }
        if (value instanceof Character character) {
            return (int) character;
        }
        return value instanceof Byte || value instanceof Short ? (Object) ((Number) value).intValue() : value;
    }
}
