package org.robonewbie.protocol.telemetry;

/**
 * Where a robot believes to be on the pitch, in the coordinates of its team: the opponents' goal is at positive x.
 *
 * @param x metres from the centre towards the opponents' goal
 * @param y metres to the left of it
 * @param headingDegrees direction of the torso, 0 towards the opponents' goal, positive is left
 */
public record BelievedPose(double x, double y, double headingDegrees) {}
