package org.robonewbie.workshop.motion;

/**
 * Outcome of one trial.
 *
 * @param success whether the criterion was met
 * @param value measured value in the unit of the check
 */
public record Outcome(boolean success, double value) {}
