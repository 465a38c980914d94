package org.robonewbie.learning.gym;

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
 * What a learning program changes about the episodes of a task. Each option is a number, or a range {@code low..high} of which
 * each episode draws a number of its own.
 *
 * <pre>{@code
 * GymOptions options = GymOptions.NONE.with("ball_x", "2.0..2.5").with("delay", "2");
 * }</pre>
 */
final class GymOptions {

    static final GymOptions NONE = new GymOptions(Map.of());

    private static final String RANGE = "..";
    private static final double MOST = 1e6;

    /** The largest speed that can be commanded, metres per second. */
    static final double MOST_SPEED = 3;

    /** The fastest turn that can be commanded, degrees per second. */
    static final double MOST_TURN = 360;

    /** The farthest that a kick can be wanted to go, metres. */
    static final double MOST_DISTANCE = 8;

    /** What can be changed. */
    private enum Name {
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
        FORWARD(-MOST_SPEED, MOST_SPEED),
        LEFT(-MOST_SPEED, MOST_SPEED),
        TURN(-MOST_TURN, MOST_TURN),
        DISTANCE(0, MOST_DISTANCE);

        private final double least;
        private final double most;

        Name() {
            this(-MOST, MOST);
        }

        Name(double least, double most) {
            this.least = least;
            this.most = most;
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

    /** From where to where a number is drawn. */
    private record Range(double low, double high) {

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
                // told below
            }
            throw new IllegalArgumentException("The option " + name.word() + "=" + text
                    + " is neither a number nor a range with the smaller number first, such as -0.5..0.5.");
        }

        private Range within(Name name, String text) {
            if (low < name.least || high > name.most) {
                throw new IllegalArgumentException("The option " + name.word() + "=" + text + " is not between "
                        + name.least + " and " + name.most + ".");
            }
            return this;
        }

        double draw(RandomSource random) {
            return low == high ? low : random.between(low, high);
        }
    }

    private final Map<Name, Range> ranges;

    private GymOptions(Map<Name, Range> ranges) {
        this.ranges = ranges;
    }

    /** Changes an option; throws an {@link IllegalArgumentException} that says what there is if there is none of this name. */
    GymOptions with(String word, String text) {
        Map<Name, Range> changed = new EnumMap<>(Name.class);
        changed.putAll(ranges);
        Name name = Name.of(word);
        changed.put(name, Range.of(name, text));
        return new GymOptions(changed);
    }

    /** These options, with actions that last so many cycles unless the options say something else. */
    GymOptions withUsualCycles(int cycles) {
        return ranges.containsKey(Name.CYCLES) ? this : with(Name.CYCLES.word(), Integer.toString(cycles));
    }

    /** Draws the numbers of an episode: independent of the chance that the task itself uses. */
    Drawn draw(long seed) {
        RandomSource random = new RandomSource(~seed);
        Map<Name, Double> numbers = new EnumMap<>(Name.class);
        ranges.forEach((name, range) -> numbers.put(name, range.draw(random)));
        return new Drawn(numbers);
    }

    /** The numbers of one episode. */
    static final class Drawn {

        private final Map<Name, Double> numbers;

        private Drawn(Map<Name, Double> numbers) {
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

        /** How far a kick is to go, in metres; empty if the task decides. */
        Optional<Double> distance() {
            return Optional.ofNullable(numbers.get(Name.DISTANCE));
        }

        /** By how much the pushes of an episode get harder each time, in newtons; empty if the task decides. */
        Optional<Double> pushNewtons() {
            return Optional.ofNullable(numbers.get(Name.PUSH));
        }

        /** How many cycles an action takes to reach the motors, in addition to none. */
        int delayCycles() {
            return (int) Math.round(of(Name.DELAY, 0));
        }

        /** How many cycles of 20 ms an action lasts. */
        int cycles() {
            return (int) Math.round(of(Name.CYCLES, 1));
        }

        /** Standard deviation of errors that come on top of what the robot feels, in the units of the readings. */
        double noise() {
            return of(Name.NOISE, 0);
        }
    }
}
