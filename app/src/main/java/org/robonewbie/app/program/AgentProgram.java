package org.robonewbie.app.program;

import java.lang.reflect.InvocationTargetException;
import java.lang.reflect.Method;
import java.lang.reflect.Modifier;
import java.util.List;
import java.util.Objects;
import java.util.Optional;
import picocli.CommandLine.ExitCode;

/** A user's program: a class with a {@code main} method. */
public final class AgentProgram {

    private final Method main;

    private AgentProgram(Method main) {
        this.main = main;
    }

    /** Takes a class as a program, if it has a public static {@code main(String[])}. */
    static Optional<AgentProgram> of(Class<?> type) {
        try {
            Method main = type.getDeclaredMethod("main", String[].class);
            boolean callable = Modifier.isStatic(main.getModifiers()) && Modifier.isPublic(main.getModifiers());
            return callable ? Optional.of(new AgentProgram(main)) : Optional.empty();
        } catch (NoSuchMethodException none) {
            return Optional.empty();
        }
    }

    /** {@return the name of the class} */
    String className() {
        return main.getDeclaringClass().getName();
    }

    /**
     * Runs the program in this thread; the trace of an uncaught exception starts at the program's own lines.
     *
     * @param options the arguments of its {@code main}
     * @return the exit code: 0, or 1 after an exception
     */
    public int run(List<String> options) {
        ClassLoader loader = main.getDeclaringClass().getClassLoader();
        Thread.currentThread().setContextClassLoader(loader);
        try {
            main.setAccessible(true);
            main.invoke(null, (Object) options.toArray(String[]::new));
            return ExitCode.OK;
        } catch (InvocationTargetException thrown) {
            report(Objects.requireNonNull(thrown.getCause()));
            return ExitCode.SOFTWARE;
        } catch (IllegalAccessException impossible) {
            throw new IllegalStateException(className() + ".main cannot be called", impossible);
        }
    }

    private void report(Throwable thrown) {
        System.err.println(className() + " ended with " + thrown);
        for (StackTraceElement line : thrown.getStackTrace()) {
            if (line.getClassName().startsWith("jdk.internal.reflect")
                    || line.getClassName().startsWith("java.lang.reflect")) {
                break;
            }
            System.err.println("    at " + line);
        }
    }
}
