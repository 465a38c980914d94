package org.robonewbie.web;

import java.io.ByteArrayOutputStream;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.util.function.BooleanSupplier;
import org.robonewbie.pagejvm.EndlessLoop;
import org.robonewbie.pagejvm.ProgramEnd;

/** State and output of a student's program, as shown next to the editor. */
final class StudentRun {

    /** The stages of a run; the program editor uses these names. */
    enum State {
        RUNNING,
        ENDED,
        STOPPED
    }

    private static final String NO_CLASS = "$FakeClass";
    private static final int MAX_CHARACTERS = 20_000;

    private final ByteArrayOutputStream bytes = new ByteArrayOutputStream();
    private final PrintStream output = new PrintStream(bytes, true, StandardCharsets.UTF_8);
    private Runnable leave = () -> {};
    private State state = State.RUNNING;
    private int exitCode;

    /** {@return the program's standard output} */
    PrintStream output() {
        return output;
    }

    /**
     * Starts a program.
     *
     * @param program the program
     * @return an action that runs the program until it waits for the next message
     */
    Runnable begin(StudentProgram program) {
        leave = program::leave;
        return () -> attempt(program::resume);
    }

    private void attempt(BooleanSupplier program) {
        if (!isRunning()) {
            return;
        }
        try {
            if (program.getAsBoolean()) {
                end(0);
            }
        } catch (ProgramEnd end) {
            end(end.exitCode());
        } catch (RuntimeException | Error mistake) {
            fail(mistake);
        }
    }

    /** Ends the run because of an exception and shows its stack trace. */
    void fail(Throwable mistake) {
        boolean isOurs = mistake instanceof EndlessLoop;
        output.println(isOurs ? mistake.getMessage() : "Exception in thread \"main\" " + mistake);
        for (StackTraceElement call : mistake.getStackTrace()) {
            if (isOfProgram(call)) {
                output.println("    at " + call);
            }
        }
        end(1);
    }

    /**
     * Returns whether a stack frame belongs to the student's program; in a page, frames of the compiled module have a placeholder for the
     * class name.
     */
    private static boolean isOfProgram(StackTraceElement call) {
        return !call.getClassName().endsWith(NO_CLASS);
    }

    private void end(int code) {
        state = State.ENDED;
        exitCode = code;
        leave.run();
    }

    /** {@return whether the program has neither exited nor been stopped} */
    boolean isRunning() {
        return state == State.RUNNING;
    }

    void stop() {
        if (isRunning()) {
            state = State.STOPPED;
            leave.run();
        }
    }

    /** {@return one line: state, exit code and output, separated by tabs} */
    String text() {
        String said = bytes.toString(StandardCharsets.UTF_8);
        String end = said.substring(Math.max(0, said.length() - MAX_CHARACTERS));
        return state + "\t" + exitCode + "\t" + end;
    }
}
