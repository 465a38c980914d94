package org.robonewbie.learning.environment;

import java.util.Arrays;
import java.util.EnumMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import org.robonewbie.agent.walk.WalkVelocity;
import org.robonewbie.nao.Vector3;
import org.robonewbie.nao.geometry.Pose2d;
import org.robonewbie.nao.text.Spelling;
import org.robonewbie.trial.RandomSource;
import org.robonewbie.trial.Trial;
import org.robonewbie.trial.WorldState;

/**
 * Options of a task. Each is a number, or a range {@code low..high} from which each episode draws.
 *
 * <pre>{@code
 * DomainRandomization options = DomainRandomization.NONE.with("ball_x", "2.0..2.5").with("delay", "2");
 * }</pre>
 */
public final class DomainRandomization {

    /** The task without options. */
    static final DomainRandomization NONE = new DomainRandomization(Map.of());

    private static final String RANGE = "..";
    private static final double MAX = 1e6;

    /** The largest speed that can be commanded, metres per second. */
    static final double MAX_SPEED = 3;

    /** The fastest turn that can be commanded, degrees per second. */
    static final double MAX_TURN = 360;

    /** The largest distance that can be wanted of a kick, metres. */
    static final double MAX_DISTANCE = 8;

    /** Names of the options. */
    enum Name {
        X,
        Y,
        HEADING,
        BALL_X,
        BALL_Y,
        PUSH,
        DELAY(0, 1000),
        CYCLES(1, 1000),
        NOISE(0, 1000),
        FRICTION(0.01, 100),
        MASS(0.1, 10),
        FORWARD(-MAX_SPEED, MAX_SPEED),
        LEFT(-MAX_SPEED, MAX_SPEED),
        TURN(-MAX_TURN, MAX_TURN),
        DISTANCE(0, MAX_DISTANCE),
        SPEED(0.01, MAX_SPEED),
        STEP(20, 1000),
        SLOW(0, 1),
        TOLERANCE(0.01, MAX),
        CONSTANT(0, 1),
        TYPE(0, 4),
        SECONDS(0.02, MAX);

        private final double min;
        private final double max;

        Name() {
            this(-MAX, MAX);
        }

        Name(double min, double max) {
            this.min = min;
            this.max = max;
        }

        static Name of(String word) {
            List<String> words = Arrays.stream(values()).map(Name::word).toList();
            return Arrays.stream(values())
                    .filter(name -> name.word().equals(word))
                    .findFirst()
                    .orElseThrow(() -> new IllegalArgumentException("There is no option \"" + word + "\"."
                            + Spelling.question(word, words)
                            + " There are: reward, " + String.join(", ", words) + "."));
        }

        String word() {
            return name().toLowerCase(Locale.ROOT);
        }
    }

    /** The interval from which a number is drawn. */
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
                // refused below
            }
            throw new IllegalArgumentException("The option " + name.word() + "=" + text
                    + " is neither a number nor a range with the smaller number first, such as -0.5..0.5.");
        }

        private Range within(Name name, String text) {
            if (low < name.min || high > name.max) {
                throw new IllegalArgumentException("The option " + name.word() + "=" + text + " is not between "
                        + name.min + " and " + name.max + ".");
            }
            return this;
        }

        double draw(RandomSource random) {
            return low == high ? low : random.between(low, high);
        }
    }

    private final Map<Name, Range> ranges;

    private DomainRandomization(Map<Name, Range> ranges) {
        this.ranges = ranges;
    }

    /** Sets an option; throws an {@link IllegalArgumentException} that lists all options if there is none of this name. */
    DomainRandomization with(String word, String text) {
        Map<Name, Range> changed = new EnumMap<>(Name.class);
        changed.putAll(ranges);
        Name name = Name.of(word);
        changed.put(name, Range.of(name, text));
        return new DomainRandomization(changed);
    }

    /**
     * Sets how many cycles an action lasts, unless an option does.
     *
     * @param cycles the number of cycles
     * @return the changed options
     */
    public DomainRandomization withDefaultCycles(int cycles) {
        return ranges.containsKey(Name.CYCLES) ? this : with(Name.CYCLES.word(), Integer.toString(cycles));
    }

    /** {@return how many cycles an action lasts} */
    public int cycles() {
        return draw(0).cycles();
    }

    /** The range of an option; empty if it is not set. */
    Optional<Range> range(Name name) {
        return Optional.ofNullable(ranges.get(name));
    }

    /** The value of an option that is no range. */
    double of(Name name, double usual) {
        return range(name).map(Range::low).orElse(usual);
    }

    /** Draws the numbers of an episode, independently of the task's own random numbers. */
    Sample draw(long seed) {
        RandomSource random = new RandomSource(~seed);
        Map<Name, Double> numbers = new EnumMap<>(Name.class);
        ranges.forEach((name, range) -> numbers.put(name, range.draw(random)));
        return new Sample(numbers);
    }

    /** The numbers of one episode. */
    static final class Sample {

        private final Map<Name, Double> numbers;

        private Sample(Map<Name, Double> numbers) {
            this.numbers = numbers;
        }

        private double of(Name name, double usual) {
            return numbers.getOrDefault(name, usual);
        }

        private boolean isAny(Name... names) {
            return Arrays.stream(names).anyMatch(numbers::containsKey);
        }

        /** Changes ground, robot and places before the task completes the scene. */
        void apply(Trial trial) {
            trial.setGrip(of(Name.FRICTION, 1));
            for (int i = 0; i < trial.now().robots().size(); i++) {
                trial.robot(i).setMassFactor(of(Name.MASS, 1));
            }
            place(trial);
        }

        private void place(Trial trial) {
            WorldState now = trial.now();
            if (isAny(Name.X, Name.Y, Name.HEADING)) {
                Pose2d usual = now.place();
                Vector3 torso = new Vector3(
                        of(Name.X, usual.x()),
                        of(Name.Y, usual.y()),
                        now.robot().position().z());
                trial.robot(0).moveUpright(torso, of(Name.HEADING, usual.degrees()) - 90);
            }
            if (isAny(Name.BALL_X, Name.BALL_Y)) {
                Vector3 usual = now.ball();
                trial.placeBall(new Vector3(of(Name.BALL_X, usual.x()), of(Name.BALL_Y, usual.y()), 0));
            }
        }

        /** The velocity that a robot is to follow; empty if the task decides. */
        Optional<WalkVelocity> command() {
            return isAny(Name.FORWARD, Name.LEFT, Name.TURN)
                    ? Optional.of(new WalkVelocity(of(Name.FORWARD, 0), of(Name.LEFT, 0), of(Name.TURN, 0)))
                    : Optional.empty();
        }

        /** The wanted distance of a kick, in metres; empty if the task decides. */
        Optional<Double> distance() {
            return Optional.ofNullable(numbers.get(Name.DISTANCE));
        }

        /** The strength of pushes, in newtons; empty if the task decides. */
        Optional<Double> pushNewtons() {
            return Optional.ofNullable(numbers.get(Name.PUSH));
        }

        /** Additional cycles until an action reaches the motors. */
        int delayCycles() {
            return (int) Math.round(of(Name.DELAY, 0));
        }

        /** How many cycles of 20 ms an action lasts. */
        int cycles() {
            return (int) Math.round(of(Name.CYCLES, 1));
        }

        /** Standard deviation of additional sensor noise, in the units of the readings. */
        double noise() {
            return of(Name.NOISE, 0);
        }
    }
}
