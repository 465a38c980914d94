package org.robonewbie.learning.objective;

import java.util.Arrays;
import java.util.Locale;
import java.util.stream.Collectors;

/** The objectives that the framework knows; what a robot does after a fall does not count. */
public enum StandardObjective implements Objective {

    /** How far the robot gets along its first heading, in metres. */
    DISTANCE_WALKED("m", true),

    /** How fast the robot gets along its first heading in the mean of the trial, in metres per second. */
    WALK_SPEED("m/s", true),

    /** Work with which the motors lift and speed up the limbs, in joules. */
    ENERGY("J", false),

    /** How much the torso leans in the mean of the trial, in degrees; after a fall 90. */
    STABILITY("degrees of tilt", false),

    /** How far the ball gets along the robot's first heading, in metres; what it will roll on counts. */
    KICK_DISTANCE("m", true),

    /** How long it takes until the ball is in the opponents' goal, in seconds; if it is not, 10 s more for each missing metre. */
    TIME_TO_SCORE("s", false);

    private final String unit;
    private final boolean largerIsBetter;

    StandardObjective(String unit, boolean largerIsBetter) {
        this.unit = unit;
        this.largerIsBetter = largerIsBetter;
    }

    /**
     * Looks up an objective.
     *
     * @param label a name such as {@code walk-speed}
     * @return the objective
     * @throws IllegalArgumentException if there is none of this name; the message lists all
     */
    public static StandardObjective labelled(String label) {
        return Arrays.stream(values())
                .filter(objective -> objective.label().equals(label))
                .findFirst()
                .orElseThrow(() -> new IllegalArgumentException(
                        "There is no objective \"" + label + "\". There are: " + labels() + "."));
    }

    /** {@return the names of all objectives, separated by commas} */
    public static String labels() {
        return Arrays.stream(values()).map(StandardObjective::label).collect(Collectors.joining(", "));
    }

    @Override
    public String label() {
        return name().toLowerCase(Locale.ROOT).replace('_', '-');
    }

    @Override
    public String unit() {
        return unit;
    }

    @Override
    public boolean isLargerBetter() {
        return largerIsBetter;
    }

    @Override
    public Gauge gauge() {
        return switch (this) {
            case DISTANCE_WALKED -> new DistanceGauge();
            case WALK_SPEED -> new SpeedGauge();
            case ENERGY -> new EnergyGauge();
            case STABILITY -> new TiltGauge();
            case KICK_DISTANCE -> new KickGauge();
            case TIME_TO_SCORE -> new ScoreGauge();
        };
    }
}
