package org.robonewbie.studio.search;

/**
 * One of the numbers that are searched for.
 *
 * @param name what it is
 * @param unit its unit, empty if it has none
 * @param start what it was at the beginning
 * @param value what it is now
 * @param spread how far the next candidates lie apart, greater than 0
 * @param size a change that is noticeable but small, in the same unit, greater than 0
 */
public record SearchNumber(String name, String unit, double start, double value, double spread, double size) {}
