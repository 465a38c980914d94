package org.robonewbie.studio.search;

/**
 * One of the numbers that a search varies.
 *
 * @param name what it is
 * @param unit its unit, empty if it has none
 * @param start its value at the beginning
 * @param value its present value
 * @param spread standard deviation of the next candidates, greater than 0
 * @param size a change that is noticeable but small, in the same unit, greater than 0
 */
public record SearchNumber(String name, String unit, double start, double value, double spread, double size) {}
