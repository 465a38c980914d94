package org.robonewbie.pagejvm;

import java.io.PrintStream;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import org.jspecify.annotations.Nullable;

/**
 * Interpreter for a student's program with an explicit call stack. A call that waits, such as {@code nao.sense()}, suspends the program
 * between two instructions; {@link #resume} continues it once the result is available.
 *
 * <pre>{@code
 * Machine machine = new Machine(new Program(classFiles), System.out, SpecialCalls.NONE);
 * machine.begin("Walker", "--team", "Blue");
 * while (!machine.resume()) { advanceTheWorld(); }
 * }</pre>
 */
public final class Machine {

    /**
     * Number of instructions between two simulator messages after which a loop counts as infinite; executing them takes a
     * few tenths of a second.
     */
    public static final long STEPS_PER_CYCLE = 5_000_000;

    /** Number of instructions after which a cycle counts as slow, because the page then falls behind real time. */
    static final long SLOW_STEPS = 500_000;

    private static final int SLOW_CYCLES_TO_REPORT = 5;
    private static final int MAX_DEPTH = 1500;

    private final Program program;
    private final PrintStream output;
    private final SpecialCalls specialCalls;
    private final Members members;
    private final List<Frame> frames = new ArrayList<>();
    private @Nullable Waiting waiting;
    private @Nullable Throwable traced;
    private @Nullable Object result;
    private long stepsLeft = STEPS_PER_CYCLE;
    private long stepsLeftAtNextCheck = STEPS_PER_CYCLE - SLOW_STEPS;
    private int slowCycles;

    /**
     * Creates a machine.
     *
     * @param program the student's program
     * @param output destination of {@code System.out} and {@code System.err}
     * @param specialCalls methods that are executed differently
     */
    public Machine(Program program, PrintStream output, SpecialCalls specialCalls) {
        this.program = program;
        this.output = output;
        this.specialCalls = specialCalls;
        members = new Members(this);
    }

    Program program() {
        return program;
    }

    PrintStream output() {
        return output;
    }

    SpecialCalls specialCalls() {
        return specialCalls;
    }

    Members members() {
        return members;
    }

    /**
     * Prepares to run a main method with {@link #resume}.
     *
     * @param type internal name of its class
     * @param arguments its arguments
     */
    public void begin(String type, String... arguments) {
        StudentMethod main = program.main(type);
        enter(main, new Object[] {arguments});
        initialise(main.home());
    }

    /**
     * Creates an instance of a student's class with the no-arg constructor.
     *
     * @param type internal name of the class
     * @return the instance
     */
    public Object create(String type) {
        StudentClass home = program.find(type).orElseThrow(() -> new Missing("The program has no class " + type));
        initialiseNow(home);
        StudentObject object = StudentObjects.create(home, this);
        call(
                home.own("<init>()V").orElseThrow(() -> new Missing(home + " has no constructor without parameters")),
                object);
        return object;
    }

    /**
     * Runs until the program ends or waits.
     *
     * @return whether the program has ended
     */
    public boolean resume() {
        Waiting pause = waiting;
        if (pause != null) {
            if (!pause.isReady()) {
                return false;
            }
            finishWaiting(pause);
        }
        run(0);
        return frames.isEmpty();
    }

    /** Resets the instruction count. Call this when a new message from the simulator has arrived. */
    public void newCycle() {
        stepsLeft = STEPS_PER_CYCLE;
        stepsLeftAtNextCheck = STEPS_PER_CYCLE - SLOW_STEPS;
    }

    /**
     * Calls a method of the program and returns its result. Blocks if the method waits.
     *
     * @param method the method
     * @param arguments the receiver, unless it is static, and the arguments
     * @return its result
     */
    @Nullable
    Object call(StudentMethod method, @Nullable Object... arguments) {
        int base = frames.size();
        enter(method, arguments);
        finish(base);
        Object value = result;
        result = null;
        return value;
    }

    /** Runs the calls above the given stack depth to completion, even while outer calls wait. */
    private void finish(int base) {
        Waiting outer = waiting;
        waiting = null;
        try {
            run(base);
            while (waiting != null) {
                Waiting pause = waiting;
                while (!pause.isReady()) {
                    pause.hurry();
                }
                finishWaiting(pause);
                run(base);
            }
        } finally {
            waiting = outer;
        }
    }

    private void finishWaiting(Waiting pause) {
        waiting = null;
        Object value = pause.result();
        if (pause instanceof Discarded) {
            return;
        }
        top().push(value);
    }

    /** Suspends the program until a call has a result, which is then pushed or discarded. */
    void await(Waiting pause, boolean isWanted) {
        waiting = isWanted ? pause : new Discarded(pause);
    }

    /** Executes instructions until the stack has shrunk to the given depth or a call waits. */
    private void run(int base) {
        while (frames.size() > base && waiting == null) {
            try {
                while (frames.size() > base && waiting == null) {
                    step();
                }
            } catch (EndlessLoop | ProgramEnd end) {
                cut(base);
                throw end;
            } catch (RuntimeException | Error mistake) {
                raise(mistake, base);
            }
        }
    }

    private void step() {
        Frame frame = top();
        frame.at = frame.next;
        if (--stepsLeft < stepsLeftAtNextCheck) {
            checkTime();
        }
        Instructions.execute(frame, this);
    }

    /** Stops an infinite loop. Also reports, once, that a program is slow in many cycles. */
    private void checkTime() {
        if (stepsLeft < 0) {
            throw new EndlessLoop(placeText(), STEPS_PER_CYCLE);
        }
        stepsLeftAtNextCheck = 0;
        slowCycles++;
        if (slowCycles == SLOW_CYCLES_TO_REPORT) {
            output.println(
                    "The program executes more than " + SLOW_STEPS + " instructions in one cycle, at " + placeText()
                            + ". There are 50 cycles per simulated second, so the page slows down."
                            + " Compute less in a cycle, or spread the work over several cycles.");
        }
    }

    /** Pushes a stack frame. */
    void enter(StudentMethod method, @Nullable Object[] arguments) {
        if (frames.size() >= MAX_DEPTH) {
            throw new StackOverflowError("Does " + method.code().name() + "() call itself without end?");
        }
        frames.add(new Frame(method, arguments));
    }

    /** Pops the innermost stack frame and passes the result to the caller, if awaited. */
    void leave(@Nullable Object value) {
        frames.remove(frames.size() - 1);
        result = value;
        if (!frames.isEmpty() && top().awaitsResult) {
            top().awaitsResult = false;
            top().push(value);
        }
    }

    /**
     * Pushes the static initialiser of a class, and above it those of its superclasses. Returns whether any was pushed.
     */
    boolean initialise(StudentClass type) {
        if (type.isInitialised) {
            return false;
        }
        type.isInitialised = true;
        boolean begun = type.own("<clinit>()V")
                .map(method -> {
                    enter(method, new Object[0]);
                    return true;
                })
                .orElse(false);
        return type.parent().map(this::initialise).orElse(false) || begun;
    }

    /** Runs the static initialiser of a class if it has not run yet. */
    void initialiseNow(StudentClass type) {
        int base = frames.size();
        initialise(type);
        finish(base);
    }

    /** Unwinds the stack to the handler of an exception; throws the exception if there is none. */
    void raise(Throwable mistake, int base) {
        if (traced != mistake && !(mistake instanceof Thrown)) {
            trace(mistake);
        }
        Throwable cause = mistake instanceof Thrown thrown ? thrown.what() : mistake;
        while (frames.size() > base) {
            Frame frame = top();
            for (ClassFile.Guard guard : frame.method.code().guards()) {
                boolean guards = frame.at >= guard.from() && frame.at < guard.to();
                if (guards && (guard.type().isEmpty() || StudentObjects.isInstance(cause, guard.type(), program))) {
                    frame.handle(cause, guard.handler());
                    return;
                }
            }
            frames.remove(frames.size() - 1);
        }
        Machine.<RuntimeException>sneakyThrow(cause);
    }

    @SuppressWarnings({"unchecked", "TypeParameterUnusedInFormals"})
    private static <T extends Throwable> void sneakyThrow(Throwable what) throws T {
        throw (T) what;
    }

    /** Sets the stack trace of an exception to the program's calls. */
    void trace(Throwable mistake) {
        traced = mistake;
        mistake.setStackTrace(trace());
    }

    /** {@return the program's calls, the innermost first} */
    public StackTraceElement[] trace() {
        List<StackTraceElement> calls = new ArrayList<>();
        frames.forEach(frame -> calls.add(frame.place()));
        Collections.reverse(calls);
        if (isInAgent()) {
            calls.add(new StackTraceElement("org.robonewbie.agent.Agent", "run", "Agent.java", -1));
        }
        return calls.toArray(StackTraceElement[]::new);
    }

    private boolean isInAgent() {
        return !frames.isEmpty() && !frames.get(0).method.code().isStatic();
    }

    private String placeText() {
        StackTraceElement place = top().place();
        return place.getFileName() + ":" + place.getLineNumber();
    }

    /** {@return the current position, such as {@code Walker.java:12}; empty if the program is not running} */
    public String place() {
        return frames.isEmpty() ? "" : placeText();
    }

    private void cut(int base) {
        while (frames.size() > base) {
            frames.remove(frames.size() - 1);
        }
    }

    private Frame top() {
        return frames.get(frames.size() - 1);
    }

    /** A wait whose result is discarded. */
    private record Discarded(Waiting pause) implements Waiting {

        @Override
        public boolean isReady() {
            return pause.isReady();
        }

        @Override
        public void hurry() {
            pause.hurry();
        }

        @Override
        public @Nullable Object result() {
            return pause.result();
        }
    }

    /** Wrapper for an exception that the program itself throws and that already has a stack trace. */
    static final class Thrown extends RuntimeException {

        private static final long serialVersionUID = 1;

        private final transient Throwable what;

        Thrown(Throwable what) {
            super(null, null, false, false);
            this.what = what;
        }

        Throwable what() {
            return what;
        }
    }
}
