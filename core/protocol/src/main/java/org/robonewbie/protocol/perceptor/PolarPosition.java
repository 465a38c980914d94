package org.robonewbie.protocol.perceptor;

/**
 * The position of an object relative to the camera in polar coordinates: {@code (pol d h v)}. The camera is at the centre of the
 * head.
 *
 * @param distanceMetres distance in metres
 * @param horizontalDegrees angle from the forward direction in the horizontal plane of the head, in degrees, positive to the
 *     left
 * @param verticalDegrees angle above the horizontal plane of the head, in degrees, positive up
 */
public record PolarPosition(double distanceMetres, double horizontalDegrees, double verticalDegrees) {}
