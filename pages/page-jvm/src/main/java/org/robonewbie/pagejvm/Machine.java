package org.robonewbie.pagejvm;

import java.io.PrintStream;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import org.jspecify.annotations.Nullable;

/**
 * Carries out a program of a student: a list of calls, the innermost last, and one instruction after the other. A call that waits, such
 * as {@code nao.sense()}, stops the program between two instructions; {@link #goOn} continues when its result is there.
 *
 * <pre>{@code
 * Machine machine = new Machine(new Program(classFiles), System.out, SpecialCalls.NONE);
 * machine.begin("Walker", "--team", "Blue");
 * while (!machine.goOn()) { turnTheWorld(); }
 * }</pre>
 */
public final class Machine {

    /** Steps from one message of the simulator to the next after which a loop is called endless; some tenths of a second. */
    public static final long STEPS_PER_CYCLE = 5_000_000;

    /** Steps after which a cycle is slow: the page takes longer for them than a message of the simulator lets it. */
    static final long SLOW_STEPS = 500_000;

    private static final int SLOW_CYCLES_TO_REPORT = 5;
    private static final int DEEPEST = 1500;

    private final Program program;
    private final PrintStream output;
    private final SpecialCalls specialCalls;
    private final Members members;
    private final List<Frame> frames = new ArrayList<>();
    private @Nullable Waiting waiting;
    private @Nullable Throwable traced;
    private @Nullable Object result;
    private long stepsLeft = STEPS_PER_CYCLE;
    private long stepsLeftAtNextLook = STEPS_PER_CYCLE - SLOW_STEPS;
    private int slowCycles;

    /**
     * Creates a machine.
     *
     * @param program its classes
     * @param output what {@code System.out} and {@code System.err} are to the program
     * @param specialCalls methods that are carried out in another way
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
     * Begins a main method; {@link #goOn} carries it out.
     *
     * @param type name of its class, with slashes
     * @param arguments its arguments
     */
    public void begin(String type, String... arguments) {
        StudentMethod main = program.main(type);
        enter(main, new Object[] {arguments});
        initialise(main.home());
    }

    /**
     * Makes an object of the program with its constructor that takes nothing.
     *
     * @param type name of its class, with slashes
     * @return the object
     */
    public Object create(String type) {
        StudentClass home = program.find(type).orElseThrow(() -> new Missing("The program has no class " + type));
        initialiseNow(home);
        StudentObject object = StudentObjects.create(home, this);
        call(
                home.own("<init>()V").orElseThrow(() -> new Missing(home + " has no constructor without arguments")),
                object);
        return object;
    }

    /**
     * Goes on until the program is over or waits.
     *
     * @return whether it is over
     */
    public boolean goOn() {
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

    /** Says that a message of the simulator has come: the steps are counted from 0 again. */
    public void newCycle() {
        stepsLeft = STEPS_PER_CYCLE;
        stepsLeftAtNextLook = STEPS_PER_CYCLE - SLOW_STEPS;
    }

    /**
     * Calls a method of the program and comes back with its result. What waits inside is awaited here.
     *
     * @param method the method
     * @param arguments the object, unless it is static, and its arguments
     * @return its result
     */
    @Nullable
    Object call(StudentMethod method, @Nullable Object... arguments) {
        int base = frames.size();
        enter(method, arguments);
        carryOut(base);
        Object value = result;
        result = null;
        return value;
    }

    /** Carries out the calls above others to their end, also while those below wait. */
    private void carryOut(int base) {
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

    /** Waits for the result of a call; it is laid down if somebody wants it. */
    void await(Waiting pause, boolean isWanted) {
        waiting = isWanted ? pause : new Discarded(pause);
    }

    /** Carries out instructions until only so many calls are left, or one waits. */
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
        if (--stepsLeft < stepsLeftAtNextLook) {
            lookAtTime();
        }
        Instructions.carryOut(frame, this);
    }

    /** Ends a loop without an end, and says once in which line the program is that needs too long in many cycles. */
    private void lookAtTime() {
        if (stepsLeft < 0) {
            throw new EndlessLoop(placeText(), STEPS_PER_CYCLE);
        }
        stepsLeftAtNextLook = 0;
        slowCycles++;
        if (slowCycles == SLOW_CYCLES_TO_REPORT) {
            output.println("The program goes more than " + SLOW_STEPS + " steps in a cycle, at " + placeText()
                    + ", and there are 50 cycles per simulated second: the page becomes slow."
                    + " Compute less in a cycle, or spread the work over several cycles.");
        }
    }

    /** Begins a call. */
    void enter(StudentMethod method, @Nullable Object[] arguments) {
        if (frames.size() >= DEEPEST) {
            throw new StackOverflowError("Does " + method.code().name() + "() call itself without an end?");
        }
        frames.add(new Frame(method, arguments));
    }

    /** Ends the innermost call. */
    void leave(@Nullable Object value) {
        frames.remove(frames.size() - 1);
        result = value;
        if (!frames.isEmpty() && top().awaitsResult) {
            top().awaitsResult = false;
            top().push(value);
        }
    }

    /** Carries out the static initialiser of a class before anything else, and those of the classes above before it. */
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

    /** Carries out the static initialiser of a class if it is due, and comes back. */
    void initialiseNow(StudentClass type) {
        int base = frames.size();
        initialise(type);
        carryOut(base);
    }

    /** Finds who handles an exception; if nobody does, it leaves the machine. */
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
        Machine.<RuntimeException>throwAsItIs(cause);
    }

    @SuppressWarnings({"unchecked", "TypeParameterUnusedInFormals"})
    private static <T extends Throwable> void throwAsItIs(Throwable what) throws T {
        throw (T) what;
    }

    /** Writes the calls of the program into an exception. */
    void trace(Throwable mistake) {
        traced = mistake;
        mistake.setStackTrace(trace());
    }

    /** {@return the calls of the program, the innermost first} */
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

    /** {@return where the program is, such as {@code Walker.java:12}; empty if it does nothing} */
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

    /** A pause whose result nobody wants. */
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

    /** An exception that the program throws itself; its calls stand in it already. */
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
