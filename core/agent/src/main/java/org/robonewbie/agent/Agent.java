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
import org.robonewbie.agent.motion.LookAround;
import org.robonewbie.agent.motion.Motions;
import org.robonewbie.agent.perception.LocalFieldView;
import org.robonewbie.agent.running.ThinkSpelling;
import org.robonewbie.agent.walk.Walk;

/**
 * A robot that thinks: the framework turns the cycle of sense, think and act, 50 times per simulated second.
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
 * <p>An exception in {@link #think} does not stop the robot: it is reported with its line, and the next cycle begins. The program
 * then ends with exit code 1.
 */
public abstract class Agent {

    private static final int MAX_CALLS = 8;
    private static final String CLASS_THAT_FAILED_BEFORE = "Could not initialize class";

    private final RobotRuntime runtime = new RobotRuntime(nameOf(getClass()));
    private final TunableNumbers numbers = TunableNumbers.of(nameOf(getClass()), runtime.diagnostics());

    /** What the robot logs; printed when the run is over. */
    protected final Logger log = runtime.log();

    /** Sensors and motors. */
    protected final Robot nao = new Robot(runtime);

    /** Motions by name. */
    protected final Motions motions = runtime.motions();

    /** A walk into any direction, faster than motions of keyframes. */
    protected final Walk walk = runtime.walk();

    /** What the robot remembers of the field. */
    protected final LocalFieldView fieldView = runtime.fieldView();

    /** The head's movement to see more; moves only in cycles in which {@code lookAround.look()} is called. */
    protected final LookAround lookAround = runtime.lookAround();

    private Session session = new Session(runtime, new SingleMessagePort(), OptionalDouble.empty(), CycleWatch.NONE);
    private Options options = Options.none();
    private boolean failed;

    /** Creates an agent that is not yet connected. */
    protected Agent() {}

    /**
     * Returns who the robot is and where it starts unless the user says otherwise. The place belongs to the number given here (1 if
     * there is none): started with another {@code --number}, the robot takes that number's place in the line-up.
     *
     * @return the usual options; override this, for example with {@code
     *     Options.none().withTeam("Blue").withPose(-1, 0, 0)}
     */
    protected Options defaults() {
        return Options.none();
    }

    /**
     * Declares a number of this program that can be tuned: by a slider of the studio while the robot plays, by hand, or by {@code
     * robonewbie optimise --agent}. It has its usual value unless a file with the name of the class, such as {@code
     * Walker.numbers}, says otherwise.
     *
     * <pre>{@code
     * private final double nearMetres = number("near", 0.3, 0.1, 0.8);
     * }</pre>
     *
     * <p>A slider changes fields of the robot that were computed from the number, as above, if its class has a constructor without
     * parameters. Asked for in {@code think()}, the number is always that of the slider.
     *
     * @param name what to call it
     * @param usual its usual value
     * @param least the smallest value that makes sense
     * @param most the largest value that makes sense
     * @return its value
     * @throws IllegalArgumentException if the usual value is not between the others
     */
    protected final double number(String name, double usual, double least, double most) {
        return numbers.declare(name, usual, least, most);
    }

    /** {@return the options of the running robot, as the user wants them; the usual ones before it runs} */
    protected final Options options() {
        return options;
    }

    /**
     * Runs the robot until the game is over. Ends the program with exit code 1 if {@link #think} failed or the connection was
     * lost, and with 2 and one sentence if it cannot start at all.
     *
     * @param args the arguments of {@code main}, see {@link Options}
     */
    public final void run(String... args) {
        runTogether(args, this);
    }

    /**
     * Runs several robots of one program in the same game, each in a thread of its own; else as {@link #run}.
     *
     * @param args the arguments of {@code main}; what they say holds for all robots
     * @param agents the robots; they need different numbers or number 0
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

    /** Turns the robot's cycle until the game is over; a message of the simulator begins each turn. */
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

    /** Decides what to do: reads sensors, sets motors, starts motions. Agents that only react need none. */
    protected void think() {}

    /** Sends what was set in this cycle. Overriding methods must call {@code super.act()} last. */
    protected void act() {
        session.act();
    }

    /** Ends the run after this cycle. */
    protected final void leaveGame() {
        session.leave();
    }

    /** Reports a misspelt {@code think()} and numbers in the program's file that it does not have. */
    final void reportWhatIsMissing() {
        ThinkSpelling.wrongIn(getClass(), Agent.class, nameOf(getClass()))
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

    /** Reports an exception, and does the rest of the cycle without the program. */
    private void report(Throwable thrown) {
        boolean reportedBefore = failed && String.valueOf(thrown.getMessage()).startsWith(CLASS_THAT_FAILED_BEFORE);
        failed = true;
        Throwable mistake = Failure.rootOf(thrown);
        String step = failedStep(thrown.getStackTrace());
        if (!reportedBefore) {
            runtime.diagnostics().reportAt(Failure.place(mistake), step + mistake.getClass(), () -> {
                log.error("%s failed: %s%s", step, mistake, stack(mistake));
                return step + " failed with " + mistake + "; the robot goes on with the next step.";
            });
        }
        session.complete();
    }

    /** There may be too little memory for more than one sentence. */
    private void reportExhausted(OutOfMemoryError exhausted) {
        failed = true;
        String step = failedStep(exhausted.getStackTrace());
        runtime.diagnostics().reportAt(Failure.place(exhausted), "memory", () -> step + " " + Failure.MEMORY);
    }

    /** The method that {@link #run} has called: the last call before it. */
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

    /** The calls that led to an exception, one below the other, without those of the framework. */
    private static String stack(Throwable mistake) {
        return Arrays.stream(mistake.getStackTrace())
                .limit(MAX_CALLS)
                .takeWhile(call -> !call.getClassName().equals(Agent.class.getName()))
                .map(call -> "\n                      at " + call)
                .distinct()
                .collect(Collectors.joining());
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
