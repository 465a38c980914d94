package org.robonewbie.studio.search;

/**
 * A parameter of an optimisation.
 *
 * @param name name of the parameter
 * @param unit its unit; may be empty
 * @param start initial value
 * @param value current value
 * @param spread standard deviation of the next candidates, greater than 0
 * @param size a small but noticeable change in the same unit, greater than 0
 */
public record SearchNumber(String name, String unit, double start, double value, double spread, double size) {}
