package org.robonewbie.learning.optimise;

/**
 * One parameter of a candidate, for display.
 *
 * @param name such as {@code keyframe 3, left knee pitch}
 * @param unit such as {@code degrees}; empty if it has none
 * @param value the number in this unit
 * @param coordinateSize by how much the number changes with 1 of its coordinate, greater than 0
 */
public record Parameter(String name, String unit, double value, double coordinateSize) {}
