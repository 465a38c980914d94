package org.robonewbie.protocol.telemetry;

/**
 * One item of telemetry of one robot at one time.
 *
 * @param team name of the robot's team
 * @param number its shirt number, 1 to 11
 * @param seconds simulated time in seconds, as in the robot's perception, which identifies the cycle
 * @param item the item
 */
public record TelemetryMessage(String team, int number, double seconds, TelemetryItem item) {}
