package org.robonewbie.learning.environment;

import java.util.Arrays;
import java.util.EnumMap;
import java.util.EnumSet;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Collectors;
import org.robonewbie.agent.walk.WalkVelocity;
import org.robonewbie.nao.Cycle;
import org.robonewbie.nao.SoccerField;
import org.robonewbie.nao.Vector3;
import org.robonewbie.nao.geometry.Pose2d;
import org.robonewbie.nao.text.Spelling;
import org.robonewbie.simulator.soccer.SoccerParameters;
import org.robonewbie.trial.RandomSource;
import org.robonewbie.trial.Trial;
import org.robonewbie.trial.WorldState;

/**
 * Options of a task and its domain randomization: each option is a number, or a range {@code low..high} from which each episode draws
 * uniformly.
 *
 * <pre>{@code
 * DomainRandomization options = DomainRandomization.NONE.with("ball_x", "2.0..2.5").with("delay", "2");
 * }</pre>
 */
public final class DomainRandomization {

    static final DomainRandomization NONE = new DomainRandomization(Map.of());

    private static final String RANGE = "..";
    private static final double MAX = 1e6;

    private static final SoccerField PITCH = SoccerParameters.beginner().field();

    /** Largest commanded speed, in metres per second. */
    static final double MAX_SPEED = 3;

    /** Largest commanded turning speed, in degrees per second. */
    static final double MAX_TURN = 360;

    /** Largest target distance of a kick, in metres. */
    static final double MAX_DISTANCE = 8;

    enum Name {
        X("start position of the robot, metres, on the pitch", -PITCH.length() / 2, PITCH.length() / 2),
        Y(X.meaning, -PITCH.width() / 2, PITCH.width() / 2),
        HEADING("start heading of the robot, degrees (0: towards the right goal)"),
        BALL_X("start position of the ball, metres, on the pitch", X.min, X.max),
        BALL_Y(BALL_X.meaning, Y.min, Y.max),
        PUSH(
                "newtons by which each push, one per second, is harder than the last; in Walk and gait tasks, the hardest push"),
        DELAY("additional cycles until an action reaches the motors", 0, 1000, true),
        CYCLES("cycles per action (1, in Walk 2); their rewards are added", 1, 1000, true),
        NOISE(
                "standard deviation of additional noise of joint angles (degrees), gyro (degrees/s) and accelerometer (m/s2)",
                0,
                1000),
        FRICTION("factor for the friction of all surfaces (1)", 0.01, 100),
        MASS("factor for the mass of the robot (1)", 0.1, 10),
        FORWARD(
                "velocity to follow in Follow, Run, engine and gait tasks, m/s and degrees/s (random)",
                -MAX_SPEED,
                MAX_SPEED),
        LEFT(FORWARD.meaning, -MAX_SPEED, MAX_SPEED),
        TURN(FORWARD.meaning, -MAX_TURN, MAX_TURN),
        DISTANCE("wanted distance of the ball in KickTo, 0 to 8 m (random, 2 to 6 m)", 0, MAX_DISTANCE),
        SPEED(
                "in gait tasks: speed straight ahead; in Walk: the highest speed that is rewarded (0.6); m/s",
                0.01,
                MAX_SPEED),
        STEP("in gait tasks: duration of a step, a multiple of 20 ms", 20, 1000),
        SLOW("in gait tasks: share of the later commands that slow down", 0, 1),
        TOLERANCE("in gait tasks: velocity error at which the reward is 0, m/s", 0.01, MAX),
        CONSTANT("in gait tasks: share of episodes with a single command (0.4)", 0, 1),
        FLIGHT("in gait tasks: cost of a second without a foot on the ground (0)", 0, MAX),
        TYPE("in gait tasks: robot type (0..4: in turn)", 0, 4, true),
        SECONDS(
                "longest duration of an episode, seconds (10; in gait tasks 9, in Walk 20, in matches 40, in Kick and motions theirs)",
                0.02,
                MAX),
        STRENGTH("factor for the maximum torque of the motors (1), drawn for each joint", 0.01, 100),
        SOLE_FRICTION("factor for the friction of the soles (1)", 0.01, 100),
        COM_FORWARD("displacement of the torso's weight from its centre, metres", -0.2, 0.2),
        COM_LEFT(COM_FORWARD.meaning, -0.2, 0.2),
        JITTER("largest additional delay of an action in cycles, drawn for each cycle", 0, 1000, true),
        HISTORY("observations that make up one: the current one and those of the actions before (1)", 1, 100, true),
        SPEEDS("1: actions are joint speeds, as fractions of the highest speed, instead of angles", 0, 1, true),
        TRUE_STATE("1: answers also contain trueState", 0, 1, true);

        /** The options that determine the spaces, and cannot be changed later. */
        private static final Set<Name> OF_SPACES = EnumSet.of(HISTORY, SPEEDS, TRUE_STATE);

        private final String meaning;
        private final double min;
        private final double max;
        private final boolean whole;

        Name(String meaning) {
            this(meaning, -MAX, MAX);
        }

        Name(String meaning, double min, double max) {
            this(meaning, min, max, false);
        }

        Name(String meaning, double min, double max, boolean whole) {
            this.meaning = meaning;
            this.min = min;
            this.max = max;
            this.whole = whole;
        }

        static Name of(String word) {
            List<String> words = Arrays.stream(values()).map(Name::word).toList();
            return Arrays.stream(values())
                    .filter(name -> name.word().equals(word))
                    .findFirst()
                    .orElseThrow(() -> new IllegalArgumentException("There is no option \"" + word + "\"."
                            + Spelling.question(word, words)
                            + " Available: reward, " + String.join(", ", words) + "."));
        }

        String meaning() {
            return meaning;
        }

        String word() {
            return name().toLowerCase(Locale.ROOT);
        }
    }

    /** Bounds of a uniform distribution; equal for a fixed value. */
    record Range(double low, double high) {

        static Range of(Name name, String text) {
            try {
                int dots = text.indexOf(RANGE);
                String low = dots < 0 ? text : text.substring(0, dots);
                String high = dots < 0 ? text : text.substring(dots + RANGE.length());
                Range range = new Range(Double.parseDouble(low), Double.parseDouble(high));
                if (range.low <= range.high) {
                    return range.within(name, text);
                }
            } catch (NumberFormatException none) {
                // Rejected below.
            }
            throw new IllegalArgumentException("The option " + name.word() + "=" + text
                    + " is neither a number nor an ascending range such as -0.5..0.5.");
        }

        private Range within(Name name, String text) {
            if (name.whole && (low != Math.rint(low) || high != Math.rint(high))) {
                throw new IllegalArgumentException(
                        "The option " + name.word() + "=" + text + " is not a whole number. Use one, such as 2.");
            }
            if ((name == Name.CYCLES || Name.OF_SPACES.contains(name)) && low != high) {
                throw new IllegalArgumentException("The option " + name.word() + "=" + text
                        + " is a range, but all actions and episodes have the same. Use a single number.");
            }
            if (low < name.min || high > name.max) {
                throw new IllegalArgumentException("The option " + name.word() + "=" + text + " is not between "
                        + name.min + " and " + name.max + ".");
            }
            return this;
        }

        double draw(RandomSource random) {
            return low == high ? low : random.between(low, high);
        }

        @Override
        public String toString() {
            return low == high ? Double.toString(low) : low + RANGE + high;
        }
    }

    private final Map<Name, Range> ranges;

    private DomainRandomization(Map<Name, Range> ranges) {
        this.ranges = ranges;
    }

    /**
     * Parses options.
     *
     * @param assignments the options, each {@code NAME=VALUE} or {@code NAME=LOW..HIGH}
     * @return the options
     * @throws IllegalArgumentException if an option does not exist or its value is invalid
     */
    public static DomainRandomization of(List<String> assignments) {
        DomainRandomization all = NONE;
        for (String assignment : assignments) {
            String[] parts = assignment.split("=", 2);
            all = all.with(parts[0], parts[parts.length - 1]);
        }
        return all;
    }

    /**
     * Returns a copy with an option set; throws an {@link IllegalArgumentException} that lists all options if the name is
     * unknown.
     */
    DomainRandomization with(String word, String text) {
        Map<Name, Range> changed = new EnumMap<>(Name.class);
        changed.putAll(ranges);
        Name name = Name.of(word);
        changed.put(name, Range.of(name, text));
        return new DomainRandomization(changed);
    }

    /**
     * Returns a copy with a default number of cycles per action; a value set by an option is kept.
     *
     * @param cycles the number of cycles
     * @return the changed options
     */
    public DomainRandomization withDefaultCycles(int cycles) {
        return ranges.containsKey(Name.CYCLES) ? this : with(Name.CYCLES.word(), Integer.toString(cycles));
    }

    /**
     * Returns the value of an option that has been {@link #draw drawn}.
     *
     * @param word the name of the option
     * @param defaultValue the value of an option that is not set
     * @return the value
     */
    public double value(String word, double defaultValue) {
        return of(Name.of(word), defaultValue);
    }

    /**
     * Checks that other options have the same observations, actions and true state.
     *
     * @throws IllegalArgumentException if not; the message contains the option that differs
     */
    void requireSameSpaces(DomainRandomization other) {
        for (Name name : Name.OF_SPACES) {
            if (of(name, name.min) != other.of(name, name.min)) {
                throw new IllegalArgumentException("The option " + name.word()
                        + " cannot be changed later. Pass it when the environment is made.");
            }
        }
    }

    /** Returns the range of an option; empty if the option is not set. */
    Optional<Range> range(Name name) {
        return Optional.ofNullable(ranges.get(name));
    }

    /** Returns the value of an option that takes a single number; {@code defaultValue} if the option is not set. */
    double of(Name name, double defaultValue) {
        return range(name).map(Range::low).orElse(defaultValue);
    }

    /** Returns the cycles of the option {@code seconds}, or those of the task. */
    int longestCycles(TrainingTask task) {
        return range(Name.SECONDS)
                .map(seconds -> (int) Math.round(seconds.low() / Cycle.SECONDS))
                .orElseGet(task::longestCycles);
    }

    /**
     * Draws the options of an episode, independently of the task's own random numbers.
     *
     * @param seed the seed of the episode
     * @return options without ranges, except the strength, of which each joint draws its own
     */
    public DomainRandomization draw(long seed) {
        RandomSource random = new RandomSource(~seed);
        Map<Name, Range> drawn = new EnumMap<>(Name.class);
        ranges.forEach((name, range) -> {
            double value = range.draw(random);
            drawn.put(name, name == Name.STRENGTH ? range : new Range(value, value));
        });
        return new DomainRandomization(drawn);
    }

    /** {@return the options as in a command line, such as {@code friction=0.5..2.0 mass=0.9}} */
    @Override
    public String toString() {
        return ranges.entrySet().stream()
                .map(set -> set.getKey().word() + "=" + set.getValue())
                .collect(Collectors.joining(" "));
    }

    private boolean isAnySet(Name... names) {
        return Arrays.stream(names).anyMatch(ranges::containsKey);
    }

    /** Applies the options for friction and positions to an episode. Call before {@link TrainingTask#begin}. */
    void apply(Trial trial) {
        trial.setGrip(of(Name.FRICTION, 1));
        WorldState now = trial.now();
        if (isAnySet(Name.X, Name.Y, Name.HEADING)) {
            Pose2d pose = now.place();
            Vector3 torso = new Vector3(
                    of(Name.X, pose.x()),
                    of(Name.Y, pose.y()),
                    now.robot().position().z());
            trial.robot(0).moveAndTurn(torso, of(Name.HEADING, pose.degrees()) - pose.degrees());
        }
        if (isAnySet(Name.BALL_X, Name.BALL_Y)) {
            Vector3 ball = now.ball();
            trial.placeBall(new Vector3(of(Name.BALL_X, ball.x()), of(Name.BALL_Y, ball.y()), 0));
        }
    }

    /** Returns the commanded velocity of an episode; empty if the task draws it. */
    Optional<WalkVelocity> command() {
        return isAnySet(Name.FORWARD, Name.LEFT, Name.TURN)
                ? Optional.of(new WalkVelocity(of(Name.FORWARD, 0), of(Name.LEFT, 0), of(Name.TURN, 0)))
                : Optional.empty();
    }

    /** {@return the number of cycles per action in an episode} */
    public int cycles() {
        return (int) Math.round(of(Name.CYCLES, 1));
    }
}
