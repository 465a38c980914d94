package org.robonewbie.agent.walk;

import java.util.Arrays;

/**
 * Parameters of a walk that a search can tune. Each has a coordinate, in which 0 is a conservative initial guess and 1
 * a noticeable change: value = guess + unit · coordinate, within limits. The constants are in the order of the
 * coordinates of {@link WalkStyle#of}.
 */
public enum WalkParameter {
    /** Height of the torso's centre above the soles, metres. */
    TORSO_HEIGHT("gait: height of the torso", 2.1, 0.335, 0.01, Double.NEGATIVE_INFINITY, 0.375),
    /** Forward tilt of the torso, degrees. */
    LEAN("gait: lean", -1.5, 5, 3),
    /** Distance of the ankles ahead of the hips, metres; a positive coordinate puts the ankles behind the hips. */
    ANKLE_OFFSET("gait: ankle offset", 1.1, 0, -0.01),
    /** Amplitude of the torso's sway over the support foot, metres. */
    SWAY_AMPLITUDE("gait: sway", -1.3, 0.02, 0.008),
    /** Phase lead of the sway, as a fraction of a step. */
    SWAY_PHASE("gait: phase of the sway", 3.3, 0, 0.1 / Math.PI),
    /** Height to which the swing foot is lifted, metres. */
    LIFT_HEIGHT("gait: lift of the foot", 0.3, 0.025, 0.01, 0.005, Double.POSITIVE_INFINITY),
    /** Fraction of a step in which both feet are on the ground. */
    DOUBLE_SUPPORT("gait: double support", -3.3, 0.2, 0.1, 0, 0.6),
    /** Tilt of the torso over the support foot, degrees. */
    ROLL("gait: roll", 0.1, 0, 2),
    /** Hip roll that lifts the swing leg sideways, degrees. */
    SWING_HIP("gait: hip of the swing leg", 0.0, 0, 2),
    /** Amplitude of the toes' pitch, up at the beginning of the swing and down at its end, degrees. */
    TOES("gait: toes", -0.3, 0, 4),
    /** Amplitude of the torso's vertical oscillation, metres. */
    BOUNCE_AMPLITUDE("gait: bounce", -2.6, 0, 0.003),
    /** Phase lead of the bounce, as a fraction of a step. */
    BOUNCE_PHASE("gait: phase of the bounce", -0.5, 0, 0.15),
    /** Lateral distance of each foot from its hip, metres. */
    FOOT_SPREAD("gait: foot spread", 3.0, 0, 0.005),
    /** Skew of the lift: 0 is symmetric, positive moves the peak to an earlier phase. */
    LIFT_SKEW("gait: skew of the lift", -1.4, 0, 0.1),
    /** Ankle correction per degree of forward tilt error. */
    ANKLE_PITCH("balance: ankle against forward tilt", 2.1, 0, 0.1),
    /** Ankle correction per degree per second of forward tilt rate. */
    ANKLE_PITCH_RATE("balance: ankle against forward tilt rate", -0.2, 0, 0.01),
    /** Hip correction per degree of forward tilt error. */
    HIP_PITCH("balance: hip against forward tilt", -0.5, 0, 0.1),
    /** Hip correction per degree per second of forward tilt rate. */
    HIP_PITCH_RATE("balance: hip against forward tilt rate", 0.7, 0, 0.01),
    /** Ankle correction per degree of sideways tilt error. */
    ANKLE_ROLL("balance: ankle against sideways tilt", 0.4, 0, 0.1),
    /** Ankle correction per degree per second of sideways tilt rate. */
    ANKLE_ROLL_RATE("balance: ankle against sideways tilt rate", 0.1, 0, 0.01),
    /** Hip correction per degree of sideways tilt error. */
    HIP_ROLL("balance: hip against sideways tilt", -1.0, 0, 0.1),
    /** Hip correction per degree per second of sideways tilt rate. */
    HIP_ROLL_RATE("balance: hip against sideways tilt rate", 1.2, 0, 0.01),
    /** Step length added per degree of forward tilt error, metres. */
    STEP_FORWARD("balance: step against forward tilt", 0.8, 0, 0.001),
    /** Step length added per degree per second of forward tilt rate, metres. */
    STEP_FORWARD_RATE("balance: step against forward tilt rate", -0.8, 0, 0.0001),
    /** Shift of the step to the right per degree of tilt error to the right, metres. */
    STEP_RIGHT("balance: step against sideways tilt", 0.5, 0, 0.001),
    /** Shift of the step to the right per degree per second of tilt rate to the right, metres. */
    STEP_RIGHT_RATE("balance: step against sideways tilt rate", 3.0, 0, 0.0001),
    /** Maximum change in the forward speed from one step to the next, metres per second. */
    SPEED_CHANGE("style: maximum acceleration", 0.9, 0.08, 0.02, 0.02, Double.POSITIVE_INFINITY),
    /** Forward tilt per metre per second of forward speed, degrees. */
    LEAN_PER_SPEED("style: lean per speed", 0.1, 0, 3),
    /** Shift of the ankles forward per metre per second of forward speed, metres. */
    ANKLE_OFFSET_PER_SPEED("style: ankle offset per speed", -1.7, 0, 0.01),
    /** Forward tilt per metre per second of speed increase in a step, degrees. */
    LEAN_PER_CHANGE("style: lean per acceleration", -0.0, 0, 10);

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

    /** {@return a short description} */
    public String description() {
        return description;
    }

    /** {@return a new array of the coordinates of the standard walk, which were found by a search in the simulator} */
    public static double[] standardCoordinates() {
        return Arrays.stream(values()).mapToDouble(each -> each.standard).toArray();
    }

    /** Returns the value of this parameter, given the coordinates of all parameters. */
    double value(double... coordinates) {
        return Math.max(least, Math.min(most, guess + unit * coordinates[ordinal()]));
    }
}
