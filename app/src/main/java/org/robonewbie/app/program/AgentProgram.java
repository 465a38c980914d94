package org.robonewbie.app.program;

import java.lang.reflect.InvocationTargetException;
import java.net.ConnectException;
import java.util.List;
import java.util.Objects;
import java.util.Optional;
import org.robonewbie.agent.log.Failure;
import org.robonewbie.agent.log.StudentCode;
import org.robonewbie.agent.running.RobotsOfProcess;
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
     * Runs the program in this thread; what ends it is reported with its own lines only.
     *
     * @param options the arguments of its {@code main}
     * @return the exit code: 0, or 1 after an exception, or if a robot could not do what the program asked it for
     */
    public int run(List<String> options) {
        ClassLoader loader = main.type().getClassLoader();
        Thread.currentThread().setContextClassLoader(loader);
        int failuresBefore = RobotsOfProcess.failures();
        try {
            main.call(options.toArray(String[]::new));
            return RobotsOfProcess.failures() > failuresBefore ? ExitCode.SOFTWARE : ExitCode.OK;
        } catch (InvocationTargetException thrown) {
            report(Objects.requireNonNull(thrown.getCause()));
            return ExitCode.SOFTWARE;
        } catch (LinkageError unprepared) {
            report(unprepared);
            return ExitCode.SOFTWARE;
        } catch (ReflectiveOperationException impossible) {
            throw new IllegalStateException(className() + ".main cannot be called", impossible);
        }
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
