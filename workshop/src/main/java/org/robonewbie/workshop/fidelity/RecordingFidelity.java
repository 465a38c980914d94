package org.robonewbie.workshop.fidelity;

import java.util.OptionalDouble;

/**
 * How closely one recording was followed; a value is empty when the recording does not show the quantity.
 *
 * @param name the recording
 * @param jointMedianDegrees median error of all joint angles
 * @param jointMaxDegrees largest error of any joint angle
 * @param torsoMedianMetres median error of the torso's position
 * @param torsoMaxMetres largest error of the torso's position
 * @param torsoMaxDegrees largest error of the torso's orientation
 * @param ballMaxMetres largest error of the ball's position
 * @param accRowsEqual share of rows, 0 to 1, whose accelerometer printed the same within one unit of the last digit
 * @param gyrRowsEqual the same of the gyro
 * @param frpRowsEqual the same of all foot plates together
 * @param restMetres error of the torso's or ball's position in the last row, the largest of all runs
 * @param restDegrees error of the torso's orientation in the last row, the largest of all runs
 * @param firstDivergenceSeconds time from a run's beginning to its first row beyond the limits, the earliest of all runs;
 *     empty when there is none
 */
public record RecordingFidelity(
        String name,
        OptionalDouble jointMedianDegrees,
        OptionalDouble jointMaxDegrees,
        OptionalDouble torsoMedianMetres,
        OptionalDouble torsoMaxMetres,
        OptionalDouble torsoMaxDegrees,
        OptionalDouble ballMaxMetres,
        OptionalDouble accRowsEqual,
        OptionalDouble gyrRowsEqual,
        OptionalDouble frpRowsEqual,
        OptionalDouble restMetres,
        OptionalDouble restDegrees,
        OptionalDouble firstDivergenceSeconds) {}
