package org.robonewbie.protocol.perceptor;

/**
 * Where the camera sees something: {@code (pol d h v)}. The camera is in the centre of the head.
 *
 * @param distanceMetres how far it is away, in metres
 * @param horizontalDegrees angle against the direction in which the head looks, in the plane of the head; positive is left
 * @param verticalDegrees angle above the plane of the head; positive is up
 */
public record PolarPosition(double distanceMetres, double horizontalDegrees, double verticalDegrees) {}
