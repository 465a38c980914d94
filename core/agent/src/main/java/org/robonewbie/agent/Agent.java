package org.robonewbie.agent;

import java.util.Arrays;
import java.util.List;
import java.util.OptionalDouble;
import java.util.stream.Collectors;
import org.robonewbie.agent.cycle.CycleWatch;
import org.robonewbie.agent.cycle.RobotRuntime;
import org.robonewbie.agent.cycle.Session;
import org.robonewbie.agent.cycle.SingleMessagePort;
import org.robonewbie.agent.log.Failure;
import org.robonewbie.agent.log.Logger;
import org.robonewbie.agent.log.StudentCode;
import org.robonewbie.agent.motion.LookAround;
import org.robonewbie.agent.motion.Motions;
import org.robonewbie.agent.perception.LocalFieldView;
import org.robonewbie.agent.running.ThinkSpelling;
import org.robonewbie.agent.walk.Walk;

/**
 * A robot program whose cycle of sense, think and act is run by the framework, 50 times per simulated second.
 *
 * <pre>{@code
 * public class Walker extends Agent {
 *     public static void main(String[] args) {
 *         new Walker().run(args);
 *     }
 *
 *     @Override
 *     protected void think() {
 *         motions.start("walk-forward");      // does nothing while it is still walking
 *     }
 * }
 * }</pre>
 *
 * <p>An exception in {@link #think} does not stop the robot: it is reported with its line, and the next cycle begins. The
 * program then ends with exit code 1.
 */
public abstract class Agent {

    private static final int MAX_CALLERS = 7;
    private static final String CLASS_THAT_FAILED_BEFORE = "Could not initialize class";

    private final RobotRuntime runtime = new RobotRuntime(nameOf(getClass()));
    private final TunableNumbers numbers = TunableNumbers.of(nameOf(getClass()), runtime.diagnostics());

    /** The robot's log, printed when the run is over. */
    protected final Logger log = runtime.log();

    /** The robot's sensors and motors. */
    protected final Robot nao = new Robot(runtime);

    /** Keyframe motions by name. */
    protected final Motions motions = runtime.motions();

    /** The omnidirectional walk, faster than keyframe motions. */
    protected final Walk walk = runtime.walk();

    /** The robot's memory of the ball, landmarks and players that its camera has seen. */
    protected final LocalFieldView fieldView = runtime.fieldView();

    /** A head scan that widens the field of view. The head moves only in cycles in which {@code lookAround.look()} is called. */
    protected final LookAround lookAround = runtime.lookAround();

    private Session session = new Session(runtime, new SingleMessagePort(), OptionalDouble.empty(), CycleWatch.NONE);
    private Options options = Options.none();
    private boolean failed;

    /** Creates an agent that is not yet connected. */
    protected Agent() {}

    /**
     * Returns the default team, number and starting pose; the user's options take precedence. The pose applies only to
     * the player number in the same options (1 if none is set): a robot started with a different {@code --number} uses
     * the default pose for that number.
     *
     * @return the default options; override this method to return others, such as
     *     {@code Options.none().withTeam("Blue").withPose(-1, 0, 0)}
     */
    protected Options defaults() {
        return Options.none();
    }

    /**
     * Declares a tunable number: a slider in the studio can change it while the robot plays, and {@code robonewbie
     * optimise --agent} can search for a better value. The number has its default value unless a file named after the
     * class, such as {@code Walker.numbers}, overrides it.
     *
     * <pre>{@code
     * private final double nearMetres = number("near", 0.3, 0.1, 0.8);
     * }</pre>
     *
     * <p>Moving a slider also updates fields that were computed from the number, as above, if the class has a no-arg
     * constructor. A call in {@code think()} always returns the slider's current value.
     *
     * @param name name of the number
     * @param usual default value
     * @param least smallest sensible value
     * @param most largest sensible value
     * @return the current value
     * @throws IllegalArgumentException if the default value is not between the smallest and the largest
     */
    protected final double number(String name, double usual, double least, double most) {
        return numbers.declare(name, usual, least, most);
    }

    /** {@return the options in effect; before the run, the default options} */
    protected final Options options() {
        return options;
    }

    /**
     * Runs the robot until the game is over. Exits with code 1 if {@link #think} failed or the connection was lost, and with
     * code 2 and a one-sentence message if the robot cannot start.
     *
     * @param args the arguments of {@code main}, see {@link Options}
     */
    public final void run(String... args) {
        runTogether(args, this);
    }

    /**
     * Runs several robots of one program in the same game, each in its own thread. Exit codes are those of {@link #run}.
     *
     * @param args the arguments of {@code main}; they apply to all robots
     * @param agents the robots; their player numbers must differ unless they are 0, which stands for any free number
     */
    public static void runTogether(String[] args, Agent... agents) {
        int exitCode;
        try {
            exitCode = Options.of(args).isHelp() ? help() : AgentRunner.run(List.of(args), List.of(agents));
        } catch (StartUpException wrong) {
            System.err.println(wrong.getMessage());
            exitCode = 2;
        }
        if (exitCode != 0) {
            System.exit(exitCode);
        }
    }

    /** Runs the cycle until the game is over; each iteration begins with a message from the simulator. */
    final void run(Session game) {
        session = game;
        while (session.next()) {
            numbers.follow(this, runtime.telemetry());
            try {
                sense();
                think();
                act();
            } catch (RuntimeException | StackOverflowError | AssertionError | LinkageError mistake) {
                report(mistake);
            } catch (OutOfMemoryError exhausted) {
                reportExhausted(exhausted);
                throw exhausted;
            }
        }
    }

    /** Reads all sensors. Overriding methods must call {@code super.sense()} first. */
    protected void sense() {
        session.sense();
    }

    /** Decides what to do: reads sensors, sets motors, starts motions. The default implementation does nothing. */
    protected void think() {}

    /** Sends the commands of this cycle. Overriding methods must call {@code super.act()} last. */
    protected void act() {
        session.act();
    }

    /** Ends the run after this cycle. */
    protected final void leaveGame() {
        session.leave();
    }

    /**
     * Reports a misspelt {@code think()}, and numbers in the file of tunable numbers that the program does not declare.
     */
    final void reportWhatIsMissing() {
        ThinkSpelling.problemIn(getClass(), Agent.class, nameOf(getClass()))
                .ifPresent(sentence -> runtime.diagnostics().reportAt("", sentence, () -> sentence));
        numbers.reportUnknown();
    }

    final void begin(Options wanted) {
        options = wanted;
    }

    final RobotRuntime runtime() {
        return runtime;
    }

    final TunableNumbers numbers() {
        return numbers;
    }

    final boolean hasFailed() {
        return failed;
    }

    /** Reports an exception from the program and completes the cycle on its behalf. */
    private void report(Throwable thrown) {
        boolean reportedBefore = failed && String.valueOf(thrown.getMessage()).startsWith(CLASS_THAT_FAILED_BEFORE);
        failed = true;
        Throwable mistake = Failure.rootOf(thrown);
        String step = failedStep(thrown.getStackTrace());
        if (!reportedBefore) {
            runtime.diagnostics()
                    .reportAt(
                            Failure.place(mistake),
                            step + mistake.getClass(),
                            () -> step + " failed with " + mistake + "; the robot continues with the next step."
                                    + callers(mistake));
        }
        session.complete();
    }

    /** Reports that the heap is exhausted. The report is short because little memory is left. */
    private void reportExhausted(OutOfMemoryError exhausted) {
        failed = true;
        String step = failedStep(exhausted.getStackTrace());
        runtime.diagnostics().reportAt(Failure.place(exhausted), "memory", () -> step + " " + Failure.MEMORY);
    }

    /** Returns the name of the step that failed, such as {@code think()}: the method that {@link #run} called. */
    private static String failedStep(StackTraceElement[] calls) {
        for (int i = 1; i < calls.length; i++) {
            if (isRun(calls[i])) {
                return calls[i - 1].getMethodName() + "()";
            }
        }
        return "think()";
    }

    private static boolean isRun(StackTraceElement call) {
        return call.getMethodName().equals("run") && call.getClassName().equals(Agent.class.getName());
    }

    /**
     * Returns a sentence that lists the calls that led to the failed line; empty if there are none. In a web page, the
     * stack trace does not contain {@link #run}.
     */
    private static String callers(Throwable mistake) {
        StackTraceElement[] step = Arrays.stream(mistake.getStackTrace())
                .takeWhile(call -> !isRun(call) && !call.getMethodName().equals("main"))
                .toArray(StackTraceElement[]::new);
        String places = StudentCode.lines(step).stream()
                .map(StudentCode::place)
                .distinct()
                .skip(1)
                .limit(MAX_CALLERS)
                .collect(Collectors.joining(", "));
        return places.isEmpty() ? "" : " Called from " + places + ".";
    }

    private static String nameOf(Class<?> type) {
        String name = type.getSimpleName();
        return name.isEmpty() ? nameOf(type.getSuperclass()) : name;
    }

    private static int help() {
        System.out.println(Options.help());
        return 0;
    }
}
