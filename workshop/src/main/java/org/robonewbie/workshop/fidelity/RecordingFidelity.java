package org.robonewbie.workshop.fidelity;

import java.util.OptionalDouble;

/**
 * Deviation of the simulation from one recording. A value is empty if the recording does not contain the quantity.
 *
 * @param name the recording
 * @param jointMedianDegrees median error of all joint angles
 * @param jointMaxDegrees maximum error of any joint angle
 * @param torsoMedianMetres median error of the torso position
 * @param torsoMaxMetres maximum error of the torso position
 * @param torsoMaxDegrees maximum error of the torso orientation
 * @param ballMaxMetres maximum error of the ball position
 * @param accRowsEqual share of rows, 0 to 1, whose accelerometer values are equal within one unit of the last printed
 *     digit
 * @param gyrRowsEqual the same for the gyro
 * @param frpRowsEqual the same for all foot plates together
 * @param restMetres error of the torso or ball position in the last row, maximum over all runs
 * @param restDegrees error of the torso orientation in the last row, maximum over all runs
 * @param firstDivergenceSeconds time from the start of a run to its first row beyond the tolerances, minimum over all
 *     runs; empty if there is none
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
