package org.robonewbie.agent;

import java.io.IOException;
import java.io.PrintStream;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.stream.Collectors;
import org.robonewbie.agent.log.Logger;
import org.robonewbie.agent.log.Mistakes;
import org.robonewbie.agent.log.StudentCode;
import org.robonewbie.agent.motion.LookAround;
import org.robonewbie.agent.motion.MotionLibrary;
import org.robonewbie.agent.motion.Motions;
import org.robonewbie.agent.perception.LocalFieldView;
import org.robonewbie.agent.walk.Walk;
import org.robonewbie.nao.TeamSide;
import org.robonewbie.protocol.effector.EffectorCommand;
import org.robonewbie.protocol.perceptor.PerceptorMessage;

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
 * <p>A mistake in {@link #think} does not stop the robot: it is reported with its line, and the next cycle begins. The program
 * then ends with exit code 1.
 */
public abstract class Agent {

    private static final int MOST_CALLS = 8;

    /** What the robot logs; printed when the run is over. */
    protected final Logger log = new Logger(nameOf(getClass()));

    private final Mistakes mistakes = new Mistakes(System.err);
    private final TunableNumbers numbers = TunableNumbers.of(nameOf(getClass()), mistakes);

    /** Sensors and motors. */
    protected final NaoBody nao = new NaoBody(log, mistakes);

    /** Motions by name. */
    protected final Motions motions = new Motions(nao.motors(), new MotionLibrary(), mistakes, nao::getBodyPosition);

    /** A walk into any direction, for those who find the motions of keyframes too slow. */
    protected final Walk walk = new Walk(nao.motors(), motions, mistakes, nao::getBodyPosition);

    /** What the robot remembers of the field. */
    protected final LocalFieldView fieldView = new LocalFieldView(mistakes);

    /** The head's movement to see more; moves only in cycles in which {@code lookAround.look()} is called. */
    protected final LookAround lookAround = new LookAround(nao.motors());

    private final Runnable senseStep = this::senseOnce;
    private final Runnable thinkStep = this::think;
    private final Runnable actStep = this::act;
    private final RehearsalPort rehearsal = new RehearsalPort();
    private final PrintStream out = System.out;
    private Session session = new Session(nao, walk, fieldView, rehearsal, OptionalDouble.empty(), System.err);
    private Options options = Options.none();
    private boolean failed;
    private boolean running;

    /** Creates an agent that is not yet connected. */
    protected Agent() {}

    /**
     * Says who the robot is and where it starts if the user does not say otherwise. The place is that of the number that stands
     * here (1 if there is none): started with another {@code --number}, the robot takes that number's place in the line-up.
     *
     * @return the usual options; an agent may override this, for example by {@code
     *     Options.none().withTeam("Blue").withPose(-1, 0, 0)}
     */
    protected Options defaults() {
        return Options.none();
    }

    /**
     * Declares a number of this program that can be tuned, by hand or by {@code robonewbie optimise --agent}. It has its usual
     * value unless a file with the name of the class, such as {@code Walker.numbers}, says otherwise.
     *
     * <pre>{@code
     * private final double nearMetres = number("near", 0.3, 0.1, 0.8);
     * }</pre>
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

    /**
     * Lists the numbers of this program.
     *
     * @return all that it has declared so far by {@link #number}, in their order
     */
    public final List<TunableNumber> numbers() {
        return numbers.list();
    }

    /**
     * Tells who the robot is and where it lives, as the user wants it.
     *
     * @return the options of the running robot; the usual ones before it runs
     */
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
            exitCode = Options.of(args).isHelp() ? help() : Game.play(List.of(args), List.of(agents));
        } catch (StartUpException wrong) {
            System.err.println(wrong.getMessage());
            exitCode = 2;
        }
        if (exitCode != 0) {
            System.exit(exitCode);
        }
    }

    /**
     * Tells the agent who it is, before it answers by {@link #respond}; in a game the framework does that.
     *
     * @param who its team and number, among others
     * @param side the half of its team
     */
    public final void introduce(Options who, TeamSide side) {
        options = who;
        nao.senses().introduce(who.team(), who.number(), side);
    }

    /**
     * Lets the agent answer one message without any simulator, for tests, learning and replay.
     *
     * @param message what the robot senses
     * @return what the robot does
     */
    public final List<EffectorCommand> respond(PerceptorMessage message) {
        rehearsal.put(message);
        cycle(Optional.empty());
        return rehearsal.answer();
    }

    /**
     * Waits for the next message and reads all sensors. Who overrides this calls {@code super.sense()} first.
     *
     * @return false if the run is over
     */
    protected boolean sense() {
        return session.sense();
    }

    /** Decides what to do: reads sensors, sets motors, starts motions. Agents that only react need none. */
    protected void think() {}

    /** Sends what was set in this cycle. Who overrides this calls {@code super.act()} last. */
    protected void act() {
        session.act();
    }

    /** Lives in a game until it is over. */
    final int live(Home home, LinkPort port, Options wanted) throws IOException {
        options = wanted;
        LastWords lastWords = new LastWords(log, home, out);
        nao.thoughts().tellTo(home.telemetry());
        numbers.reportUnknown();
        try {
            new StartDialogue(port, nao, options).run();
            OptionalDouble life = home.endsByItself() ? OptionalDouble.empty() : options.seconds();
            session = new Session(nao, walk, fieldView, port, life, System.err);
            Optional<Runnable> giveUp = options.isHeadless() ? Optional.of(() -> System.exit(1)) : Optional.empty();
            try (Watchdog watchdog = new Watchdog(mistakes, giveUp)) {
                session.askWhenLate(watchdog::slowPlace);
                Optional<Watchdog> guard = Optional.of(watchdog);
                do {
                    cycle(guard);
                } while (running);
            }
            return failed || session.isBroken() ? 1 : 0;
        } finally {
            session.close();
            lastWords.close();
        }
    }

    final LinkPort portTo(Home home) throws IOException {
        return new LinkPort(home.connect(), nao.senses().buffer());
    }

    /** One turn of sense, think and act; whatever fails, the simulator gets its answer. */
    private void cycle(Optional<Watchdog> watchdog) {
        long before = session.cycles();
        running = true;
        attempt("sense()", senseStep);
        if (session.cycles() == before && running) {
            mistakes.reportAt("", "sense", () -> "sense() did not call super.sense(); the framework does it.");
            running = session.sense();
        }
        if (running) {
            watchdog.ifPresent(Watchdog::thinkBegins);
            attempt("think()", thinkStep);
            watchdog.ifPresent(Watchdog::thinkEnds);
            attempt("act()", actStep);
            if (session.isAnswerDue()) {
                mistakes.reportAt("", "act", () -> "act() did not call super.act(); the framework does it.");
                session.act();
            }
        }
    }

    private void senseOnce() {
        running = sense();
    }

    private void attempt(String name, Runnable step) {
        try {
            step.run();
        } catch (RuntimeException | StackOverflowError | AssertionError mistake) {
            failed = true;
            report(name, mistake);
        }
    }

    private void report(String name, Throwable mistake) {
        String place = StudentCode.place(mistake.getStackTrace()).orElse("");
        mistakes.reportAt(place, name + mistake.getClass(), () -> {
            log.error("%s failed: %s%s", name, mistake, stack(mistake));
            return name + " failed with " + mistake + "; the robot goes on with the next step.";
        });
    }

    /** Where a mistake happened, one call below the other; what lies outside of the student's code is left out. */
    private static String stack(Throwable mistake) {
        return Arrays.stream(mistake.getStackTrace())
                .limit(MOST_CALLS)
                .takeWhile(call -> !call.getClassName().equals(Agent.class.getName()))
                .map(call -> "\n                      at " + call)
                .collect(Collectors.joining());
    }

    private static String nameOf(Class<?> type) {
        return type.isAnonymousClass() ? nameOf(type.getSuperclass()) : type.getSimpleName();
    }

    private static int help() {
        System.out.println(Options.help());
        return 0;
    }
}
