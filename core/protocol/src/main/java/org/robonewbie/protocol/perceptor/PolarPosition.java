package org.robonewbie.protocol.perceptor;

/**
 * The position of an object as seen by the camera, in polar coordinates: {@code (pol d h v)}. The camera is in the centre of
 * the head.
 *
 * @param distanceMetres distance in metres
 * @param horizontalDegrees angle from the direction in which the head looks, in the plane of the head; positive is left
 * @param verticalDegrees angle above the plane of the head; positive is up
 */
public record PolarPosition(double distanceMetres, double horizontalDegrees, double verticalDegrees) {}
