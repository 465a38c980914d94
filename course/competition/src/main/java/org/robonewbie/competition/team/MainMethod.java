package org.robonewbie.competition.team;

import java.lang.reflect.Constructor;
import java.lang.reflect.InvocationTargetException;
import java.lang.reflect.Method;
import java.lang.reflect.Modifier;
import java.util.Arrays;
import java.util.Optional;
import java.util.stream.Stream;

/**
 * The method with which a program begins: {@code public static void main(String[] args)}, and from Java 25 on a {@code main} that is
 * neither public nor static, with or without parameter (JEP 512).
 */
public final class MainMethod {

    /** The first Java with the short forms. */
    public static final int JAVA_OF_SHORT_FORMS = 25;

    private final Method method;

    private MainMethod(Method method) {
        this.method = method;
    }

    /**
     * Looks for the method.
     *
     * @param type a class
     * @return its own main method; empty if it has none with which this Java begins
     */
    public static Optional<MainMethod> of(Class<?> type) {
        return of(type, Runtime.version().feature());
    }

    /** Looks for the method with which a version of Java begins. */
    static Optional<MainMethod> of(Class<?> type, int javaVersion) {
        Optional<Method> withArguments = declared(type, String[].class);
        Optional<Method> main = javaVersion >= JAVA_OF_SHORT_FORMS
                ? withArguments.or(() -> declared(type))
                : withArguments.filter(MainMethod::isClassic);
        return main.map(MainMethod::new);
    }

    /**
     * Looks for a method with which only a newer Java begins.
     *
     * @param type a class without a main method for this Java
     * @return whether it has one in a short form
     */
    public static boolean isShort(Class<?> type) {
        return of(type, JAVA_OF_SHORT_FORMS).isPresent();
    }

    private static boolean isClassic(Method main) {
        return Modifier.isPublic(main.getModifiers()) && Modifier.isStatic(main.getModifiers());
    }

    private static Optional<Method> declared(Class<?> type, Class<?>... parameters) {
        return Stream.of(type.getDeclaredMethods())
                .filter(method -> method.getName().equals("main") && method.getReturnType() == void.class)
                .filter(method -> Arrays.equals(method.getParameterTypes(), parameters))
                .filter(method -> !Modifier.isPrivate(method.getModifiers()))
                .filter(method -> Modifier.isStatic(method.getModifiers()) || hasConstructor(type))
                .findFirst();
    }

    private static boolean hasConstructor(Class<?> type) {
        return !Modifier.isAbstract(type.getModifiers())
                && Stream.of(type.getDeclaredConstructors())
                        .anyMatch(each -> each.getParameterCount() == 0 && !Modifier.isPrivate(each.getModifiers()));
    }

    /** {@return the class} */
    public Class<?> type() {
        return method.getDeclaringClass();
    }

    /**
     * Runs the program.
     *
     * @param arguments what it receives, if it takes arguments
     * @throws InvocationTargetException if it ends with an exception
     * @throws ReflectiveOperationException if it cannot be called
     */
    public void call(String... arguments) throws ReflectiveOperationException {
        method.setAccessible(true);
        Object[] parameters = method.getParameterCount() == 0 ? new Object[0] : new Object[] {arguments};
        method.invoke(Modifier.isStatic(method.getModifiers()) ? null : instance(), parameters);
    }

    private Object instance() throws ReflectiveOperationException {
        Constructor<?> constructor = type().getDeclaredConstructor();
        constructor.setAccessible(true);
        return constructor.newInstance();
    }
}
