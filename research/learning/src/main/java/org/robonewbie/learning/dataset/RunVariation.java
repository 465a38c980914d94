package org.robonewbie.learning.dataset;

import java.util.List;
import java.util.Locale;
import java.util.Optional;
import org.robonewbie.learning.environment.DomainRandomization;
import org.robonewbie.nao.PlayMode;
import org.robonewbie.nao.TeamSide;
import org.robonewbie.nao.Vector3;
import org.robonewbie.nao.text.Spelling;
import org.robonewbie.protocol.order.Order;
import org.robonewbie.protocol.order.PlayerNumber;
import org.robonewbie.simulator.RobotSnapshot;
import org.robonewbie.simulator.SimulationControl;
import org.robonewbie.simulator.SimulationObserver;
import org.robonewbie.simulator.WorldSnapshot;
import org.robonewbie.simulator.cycle.WorldSettings;
import org.robonewbie.simulator.soccer.SoccerParameter;
import org.robonewbie.simulator.soccer.SoccerParameters;
import org.robonewbie.trial.RandomSource;
import org.robonewbie.trial.measure.Pushes;

/**
 * What differs between the runs of a data set: start poses, ball, friction, mass and pushes, drawn from the seed of each run.
 *
 * @param isLeague whether the pitch and the rules are those of the league; a match starts by itself on either pitch
 * @param metres largest offset of robots and ball along each axis at the start
 * @param degrees largest turn of a robot at the start
 * @param options ranges for {@code friction}, {@code mass} and {@code push}, the force of the hardest push in newtons
 */
public record RunVariation(boolean isLeague, double metres, double degrees, DomainRandomization options) {

    private static final String FRICTION = "friction";
    private static final String MASS = "mass";
    private static final String PUSH = "push";
    private static final List<String> NAMES = List.of(FRICTION, MASS, PUSH);
    private static final double MAX_METRES = 10;
    private static final double MAX_DEGREES = 180;

    /**
     * Creates a variation.
     *
     * @param isLeague whether the pitch and the rules are those of the league
     * @param metres largest offset of robots and ball along each axis at the start
     * @param degrees largest turn of a robot at the start
     * @param options each {@code NAME=VALUE} or {@code NAME=LOW..HIGH}
     * @return the variation
     * @throws IllegalArgumentException if a number or an option is invalid; the message says which
     */
    public static RunVariation of(boolean isLeague, double metres, double degrees, List<String> options) {
        if (!(metres >= 0 && metres <= MAX_METRES) || !(degrees >= 0 && degrees <= MAX_DEGREES)) {
            throw new IllegalArgumentException("The spread is " + metres + " m and " + degrees
                    + " degrees. Choose at most " + MAX_METRES + " m and " + MAX_DEGREES + " degrees.");
        }
        for (String option : options) {
            String name = option.split("=", 2)[0];
            if (!NAMES.contains(name)) {
                throw new IllegalArgumentException("Runs of an agent have no option \"" + name + "\"."
                        + Spelling.question(name, NAMES) + " Available: " + String.join(", ", NAMES) + ".");
            }
        }
        return new RunVariation(isLeague, metres, degrees, DomainRandomization.of(options));
    }

    /** {@return whether runs start in different places or have options} */
    public boolean isRandom() {
        return metres > 0 || degrees > 0 || !options.toString().isEmpty();
    }

    /** {@return pitch and rules of all runs} */
    public SoccerParameters parameters() {
        SoccerParameters rules = isLeague ? SoccerParameters.league() : SoccerParameters.beginner();
        SoccerParameters beginner = SoccerParameters.beginner();
        for (SoccerParameter same : List.of(
                SoccerParameter.AUTOMATIC_KICK_OFF,
                SoccerParameter.WAIT_BEFORE_KICK_OFF,
                SoccerParameter.BEAM_GRACE_TIME)) {
            rules = rules.with(same, beginner.get(same));
        }
        return rules.with(SoccerParameter.BEAM_NOISE_XY, metres).with(SoccerParameter.BEAM_NOISE_ANGLE, degrees);
    }

    /** Returns the settings of a run. */
    WorldSettings settings(long seed) {
        return WorldSettings.beginner().withParameters(parameters()).withSeed(seed);
    }

    /** Adds the differences that the settings do not express to a run that has not begun. */
    void applyTo(SimulationControl control, long seed) {
        control.addObserver(new Run(control, options.draw(seed), new RandomSource(31 * ~seed + 17)));
    }

    /** {@return the differences in words, for the description of the data set} */
    @Override
    public String toString() {
        return String.format(Locale.ROOT, "%s m, %s degrees %s", metres, degrees, options)
                .strip();
    }

    /** The differences of one run. */
    private final class Run implements SimulationObserver {

        private final SimulationControl control;
        private final DomainRandomization drawn;
        private final RandomSource random;
        private final Optional<Pushes> pushes;
        private long lastCycle = -1;
        private int robots;
        private boolean began;

        Run(SimulationControl control, DomainRandomization drawn, RandomSource random) {
            this.control = control;
            this.drawn = drawn;
            this.random = random;
            double newtons = drawn.value(PUSH, 0);
            this.pushes =
                    newtons == 0 ? Optional.empty() : Optional.of(Pushes.random(() -> random.between(0, 1), newtons));
        }

        @Override
        public void cycleEnded(WorldSnapshot world) {
            if (world.cycle() == lastCycle) {
                return;
            }
            lastCycle = world.cycle();
            if (world.robots().size() > robots) {
                robots = world.robots().size();
                control.order(new Order.SetProperties(drawn.value(FRICTION, 1), drawn.value(MASS, 1)));
            }
            if (!began && world.playMode() != PlayMode.BEFORE_KICK_OFF) {
                began = true;
                Vector3 offset = new Vector3(random.between(-metres, metres), random.between(-metres, metres), 0);
                control.order(new Order.MoveBall(world.ballPosition().plus(offset), Vector3.ZERO));
            }
            pushes.flatMap(each -> each.at(world.cycle())).ifPresent(force -> push(world, force));
        }

        private void push(WorldSnapshot world, Vector3 force) {
            for (RobotSnapshot robot : world.robots()) {
                Optional<TeamSide> side = robot.side();
                if (side.isPresent()) {
                    control.order(new Order.PushRobot(new PlayerNumber(side.get(), robot.number()), force));
                }
            }
        }
    }
}
