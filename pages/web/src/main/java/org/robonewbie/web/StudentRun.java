package org.robonewbie.web;

import java.io.ByteArrayOutputStream;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.util.function.BooleanSupplier;
import org.robonewbie.pagejvm.EndlessLoop;
import org.robonewbie.pagejvm.ProgramEnd;

/** How far a student's program is: what a page shows beside the editor. */
final class StudentRun {

    /** The stages, with the names that the room for programs knows. */
    enum State {
        /** It runs. */
        RUNNING,
        /** It has ended by itself. */
        ENDED,
        /** It was stopped. */
        STOPPED
    }

    private static final String NO_CLASS = "$FakeClass";
    private static final int MOST_CHARACTERS = 20_000;

    private final ByteArrayOutputStream bytes = new ByteArrayOutputStream();
    private final PrintStream output = new PrintStream(bytes, true, StandardCharsets.UTF_8);
    private Runnable leave = () -> {};
    private State state = State.RUNNING;
    private int exitCode;

    /** {@return where the program prints} */
    PrintStream output() {
        return output;
    }

    /**
     * Begins a program.
     *
     * @param program the program
     * @return carries it out until it waits for the next message
     */
    Runnable begin(StudentProgram program) {
        leave = program::leave;
        return () -> attempt(program::goOn);
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

    /** Ends the run with a mistake, which is shown with the calls that led to it. */
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

    /** Calls of the compiled program itself have a placeholder for a name in a page. */
    private static boolean isOfProgram(StackTraceElement call) {
        return !call.getClassName().endsWith(NO_CLASS);
    }

    private void end(int code) {
        state = State.ENDED;
        exitCode = code;
        leave.run();
    }

    /** {@return whether it has neither ended nor been stopped} */
    boolean isRunning() {
        return state == State.RUNNING;
    }

    /** Stops the program. */
    void stop() {
        if (isRunning()) {
            state = State.STOPPED;
            leave.run();
        }
    }

    /** {@return one line: the state, the exit code, and then what was printed} */
    String text() {
        String said = bytes.toString(StandardCharsets.UTF_8);
        String end = said.substring(Math.max(0, said.length() - MOST_CHARACTERS));
        return state + "\t" + exitCode + "\t" + end;
    }
}
