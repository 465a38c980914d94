package org.robonewbie.workshop.motion;

/**
 * How one trial ended.
 *
 * @param success whether it kept to the rule of success
 * @param value what was measured, in the unit of the check
 */
public record Outcome(boolean success, double value) {}
