package org.robonewbie.protocol.telemetry;

/**
 * What one robot tells at one time.
 *
 * @param team name of the robot's team
 * @param number number on its shirt, 1 to 11
 * @param seconds simulated time in seconds, as in the robot's perception, which tells the cycle
 * @param item what it tells
 */
public record TelemetryMessage(String team, int number, double seconds, TelemetryItem item) {}
