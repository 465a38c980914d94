package org.robonewbie.programs;

import java.lang.reflect.Constructor;
import java.lang.reflect.InvocationTargetException;
import java.lang.reflect.Method;
import java.lang.reflect.Modifier;
import java.net.ConnectException;
import java.util.Arrays;
import java.util.List;
import java.util.Objects;
import java.util.Optional;
import java.util.stream.Stream;
import org.robonewbie.agent.log.Failure;
import org.robonewbie.agent.log.StudentCode;
import org.robonewbie.agent.running.RobotsOfProcess;

/**
 * A program with a main method: {@code public static void main(String[] args)}. From Java 25 on, the method may also be
 * non-public, non-static or without a parameter (JEP 512).
 */
public final class Program {

    /** First version of Java that supports short forms of the main method. */
    static final int JAVA_OF_SHORT_FORMS = 25;

    private final Class<?> type;
    private final Method main;

    private Program(Class<?> type, Method main) {
        this.type = type;
        this.main = main;
    }

    /**
     * Creates a program from a class.
     *
     * @param type the class
     * @return the program; empty if the class declares no main method that this version of Java can launch
     */
    public static Optional<Program> of(Class<?> type) {
        return of(type, Runtime.version().feature());
    }

    static Optional<Program> of(Class<?> type, int javaVersion) {
        Optional<Method> withArguments = declared(type, String[].class);
        Optional<Method> main = javaVersion >= JAVA_OF_SHORT_FORMS
                ? withArguments.or(() -> declared(type))
                : withArguments.filter(Program::isClassic);
        return main.map(method -> new Program(type, method));
    }

    /**
     * Creates a program from a class that may inherit its main method.
     *
     * @param type the class
     * @return the program
     * @throws CalledWronglyException if the class has no main method
     */
    public static Program ofAny(Class<?> type) {
        return of(type).or(() -> Stream.of(type.getMethods())
                        .filter(method -> method.getName().equals("main") && isClassic(method))
                        .findFirst()
                        .map(method -> new Program(type, method)))
                .orElseThrow(() -> ProgramFinder.withoutMain(type));
    }

    /**
     * Returns whether Java {@value #JAVA_OF_SHORT_FORMS}, which supports short forms of the main method, can launch the
     * class.
     */
    static boolean isShort(Class<?> type) {
        return of(type, JAVA_OF_SHORT_FORMS).isPresent();
    }

    private static boolean isClassic(Method main) {
        return Modifier.isPublic(main.getModifiers())
                && Modifier.isStatic(main.getModifiers())
                && Arrays.equals(main.getParameterTypes(), new Class<?>[] {String[].class});
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

    /** {@return the name of the program's class} */
    String className() {
        return type.getName();
    }

    /**
     * Runs the program on the current thread. If it throws an exception, only the program's own lines of the stack
     * trace are printed.
     *
     * @param options the arguments for its {@code main}
     * @return the exit code: 0, or 1 if the program threw an exception or one of its robots failed
     */
    public int run(List<String> options) {
        Thread.currentThread().setContextClassLoader(type.getClassLoader());
        int failuresBefore = RobotsOfProcess.failures();
        try {
            call(options.toArray(String[]::new));
            return RobotsOfProcess.failures() > failuresBefore ? 1 : 0;
        } catch (InvocationTargetException thrown) {
            report(Objects.requireNonNull(thrown.getCause()));
            return 1;
        } catch (LinkageError unprepared) {
            report(unprepared);
            return 1;
        } catch (ReflectiveOperationException impossible) {
            throw new IllegalStateException(className() + ".main cannot be called", impossible);
        }
    }

    void call(String... arguments) throws ReflectiveOperationException {
        main.setAccessible(true);
        Object[] parameters = main.getParameterCount() == 0 ? new Object[0] : new Object[] {arguments};
        main.invoke(Modifier.isStatic(main.getModifiers()) ? null : instance(), parameters);
    }

    private Object instance() throws ReflectiveOperationException {
        Constructor<?> constructor = type.getDeclaredConstructor();
        constructor.setAccessible(true);
        return constructor.newInstance();
    }

    private void report(Throwable thrown) {
        Throwable mistake = Failure.rootOf(thrown);
        List<StackTraceElement> own = StudentCode.lines(mistake.getStackTrace());
        String place = own.isEmpty() ? "" : " (" + Failure.place(mistake) + ")";
        System.err.println(className()
                + (mistake instanceof OutOfMemoryError ? " " + Failure.MEMORY : " ended with " + mistake)
                + place);
        if (own.isEmpty()) {
            print(List.of(mistake.getStackTrace()));
        } else if (mistake instanceof Exception && own.size() > 1) {
            print(own);
        }
        if (thrown instanceof ConnectException || thrown.getCause() instanceof ConnectException) {
            System.err.println(
                    "No server answers there. If the program needs a simulator, start one first: robonewbie simulator");
        }
    }

    private static void print(List<StackTraceElement> calls) {
        calls.forEach(call -> System.err.println("    at " + call));
    }
}
