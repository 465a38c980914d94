package org.robonewbie.agent.walk;

import java.util.Arrays;

/**
 * The numbers of a walk that a search may change. Each has a coordinate, in which 0 is a careful first guess and 1 a noticeable
 * change: value = guess + unit · coordinate, within limits. Their order is that of the coordinates of {@link WalkStyle#of}; the
 * first {@link Gait#PARAMETERS} make a {@link Gait}.
 */
public enum WalkParameter {
    /** Height of the torso's centre above the soles, metres. */
    TORSO_HEIGHT("gait: height of the torso", 2.1, 0.335, 0.01, Double.NEGATIVE_INFINITY, 0.375),
    /** How much the torso bends forward, degrees. */
    LEAN("gait: lean", -1.5, 5, 3),
    /** How far the ankles stand ahead of the hips, metres; a positive coordinate puts them behind. */
    ANKLE_OFFSET("gait: feet behind the hips", 1.1, 0, -0.01),
    /** How far the torso sways over the support foot, metres. */
    SWAY_AMPLITUDE("gait: sway", -1.3, 0.02, 0.008),
    /** By which part of a step the swaying is early. */
    SWAY_PHASE("gait: phase of the sway", 3.3, 0, 0.1 / Math.PI),
    /** How high the swing foot is lifted, metres. */
    LIFT_HEIGHT("gait: lift of the foot", 0.3, 0.025, 0.01, 0.005, Double.POSITIVE_INFINITY),
    /** Which part of a step both feet stay on the ground. */
    DOUBLE_SUPPORT("gait: time on both feet", -3.3, 0.2, 0.1, 0, 0.6),
    /** How much the torso leans over the support foot, degrees. */
    ROLL("gait: roll", 0.1, 0, 2),
    /** How much the hip lifts the swing leg to the side, degrees. */
    SWING_HIP("gait: hip of the swinging leg", 0.0, 0, 2),
    /** How much the toes rise at the beginning of the swing and sink at its end, degrees. */
    TOES("gait: toes", -0.3, 0, 4),
    /** How far the torso rises and sinks in each step, metres. */
    BOUNCE_AMPLITUDE("gait: bounce", -2.6, 0, 0.003),
    /** By which part of a step the rising is early. */
    BOUNCE_PHASE("gait: phase of the bounce", -0.5, 0, 0.15),
    /** How much wider than the hips each foot is set, metres. */
    FOOT_SPREAD("gait: distance of the feet", 3.0, 0, 0.005),
    /** 0 lifts the foot evenly; positive is highest late in the step. */
    LIFT_SKEW("gait: skew of the lift", -1.4, 0, 0.1),
    /** Ankle for each degree of bending too far forward. */
    ANKLE_PITCH("balance: ankle against bowing", 2.1, 0, 0.1),
    /** Ankle for each degree per second of bending forward. */
    ANKLE_PITCH_RATE("balance: ankle against the speed of bowing", -0.2, 0, 0.01),
    /** Hip for each degree of bending too far forward. */
    HIP_PITCH("balance: hip against bowing", -0.5, 0, 0.1),
    /** Hip for each degree per second of bending forward. */
    HIP_PITCH_RATE("balance: hip against the speed of bowing", 0.7, 0, 0.01),
    /** Ankle for each degree of leaning too far to the right. */
    ANKLE_ROLL("balance: ankle against leaning aside", 0.4, 0, 0.1),
    /** Ankle for each degree per second of leaning to the right. */
    ANKLE_ROLL_RATE("balance: ankle against the speed of leaning aside", 0.1, 0, 0.01),
    /** Hip for each degree of leaning too far to the right. */
    HIP_ROLL("balance: hip against leaning aside", -1.0, 0, 0.1),
    /** Hip for each degree per second of leaning to the right. */
    HIP_ROLL_RATE("balance: hip against the speed of leaning aside", 1.2, 0, 0.01),
    /** Metres that the step is longer for each degree of bending too far forward. */
    STEP_FORWARD("balance: step against bowing", 0.8, 0, 0.001),
    /** Metres that the step is longer for each degree per second of bending forward. */
    STEP_FORWARD_RATE("balance: step against the speed of bowing", -0.8, 0, 0.0001),
    /** Metres that the step goes further to the right for each degree of leaning too far there. */
    STEP_RIGHT("balance: step against leaning aside", 0.5, 0, 0.001),
    /** Metres that the step goes further to the right for each degree per second of leaning there. */
    STEP_RIGHT_RATE("balance: step against the speed of leaning aside", 3.0, 0, 0.0001),
    /** How much the speed forward changes from one step to the next, metres per second. */
    SPEED_CHANGE("style: change of speed in a step", 0.9, 0.08, 0.02, 0.02, Double.POSITIVE_INFINITY),
    /** Degrees that the torso bends forward for each metre per second. */
    LEAN_PER_SPEED("style: lean for speed", 0.1, 0, 3),
    /** Metres that the ankles stand further ahead for each metre per second. */
    ANKLE_OFFSET_PER_SPEED("style: feet ahead for speed", -1.7, 0, 0.01),
    /** Degrees that the torso bends forward for each metre per second that the walk becomes faster in a step. */
    LEAN_PER_CHANGE("style: lean for a change of speed", -0.0, 0, 10);

    private final String description;
    private final double standard;
    private final double guess;
    private final double unit;
    private final double least;
    private final double most;

    WalkParameter(String description, double standard, double guess, double unit) {
        this(description, standard, guess, unit, Double.NEGATIVE_INFINITY, Double.POSITIVE_INFINITY);
    }

    WalkParameter(String description, double standard, double guess, double unit, double least, double most) {
        this.description = description;
        this.standard = standard;
        this.guess = guess;
        this.unit = unit;
        this.least = least;
        this.most = most;
    }

    /** {@return what the parameter changes, in a few words} */
    public String description() {
        return description;
    }

    /** {@return the coordinates of the standard walk, which were found by a search in the simulator; a new array} */
    public static double[] standardCoordinates() {
        return Arrays.stream(values()).mapToDouble(each -> each.standard).toArray();
    }

    /** The value that belongs to this parameter's coordinate among all. */
    double value(double... coordinates) {
        return Math.max(least, Math.min(most, guess + unit * coordinates[ordinal()]));
    }
}
