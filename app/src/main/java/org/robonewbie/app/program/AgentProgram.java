package org.robonewbie.app.program;

import java.lang.reflect.InvocationTargetException;
import java.net.ConnectException;
import java.util.List;
import java.util.Objects;
import java.util.Optional;
import org.robonewbie.competition.team.MainMethod;
import picocli.CommandLine.ExitCode;

/** A user's program: a class with a {@code main} method. */
public final class AgentProgram {

    private final MainMethod main;

    private AgentProgram(MainMethod main) {
        this.main = main;
    }

    /** Takes a class as a program, if it has a main method. */
    static Optional<AgentProgram> of(Class<?> type) {
        return MainMethod.of(type).map(AgentProgram::new);
    }

    /** {@return the name of the class} */
    String className() {
        return main.type().getName();
    }

    /**
     * Runs the program in this thread; the trace of an uncaught exception starts at the program's own lines.
     *
     * @param options the arguments of its {@code main}
     * @return the exit code: 0, or 1 after an exception
     */
    public int run(List<String> options) {
        ClassLoader loader = main.type().getClassLoader();
        Thread.currentThread().setContextClassLoader(loader);
        try {
            main.call(options.toArray(String[]::new));
            return ExitCode.OK;
        } catch (InvocationTargetException thrown) {
            report(Objects.requireNonNull(thrown.getCause()));
            return ExitCode.SOFTWARE;
        } catch (ReflectiveOperationException impossible) {
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
        if (thrown instanceof ConnectException || thrown.getCause() instanceof ConnectException) {
            System.err.println(
                    "No server answers there. If the program needs a simulator, start one first: robonewbie simulator");
        }
    }
}
