package org.robonewbie.learning.optimise;

/**
 * One parameter of a candidate, as shown to the user.
 *
 * @param name a name such as {@code keyframe 3, left knee pitch}
 * @param unit a unit such as {@code degrees}; empty if there is none
 * @param value the value in this unit
 * @param coordinateSize the change of the value per unit of its coordinate, greater than 0
 */
public record Parameter(String name, String unit, double value, double coordinateSize) {}
