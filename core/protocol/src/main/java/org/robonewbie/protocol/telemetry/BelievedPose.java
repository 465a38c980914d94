package org.robonewbie.protocol.telemetry;

/**
 * A robot's belief about its own pose, in the coordinates of its team: the opponents' goal is at positive x.
 *
 * @param x metres from the centre towards the opponents' goal
 * @param y metres to the left of it
 * @param headingDegrees heading of the torso, 0 towards the opponents' goal, positive to the left
 */
public record BelievedPose(double x, double y, double headingDegrees) {}
