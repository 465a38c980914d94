package org.robonewbie.learning.experiment;

/**
 * One number of an observation.
 *
 * @param name such as {@code joint.LEFT_KNEE_PITCH}
 * @param unit such as {@code degrees}
 * @param least smallest value that is to be expected
 * @param greatest greatest value that is to be expected
 */
public record ObservedQuantity(String name, String unit, double least, double greatest) {}
