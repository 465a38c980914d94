package org.robonewbie.protocol.telemetry;

/**
 * A telemetry item, together with the robot that sent it and the simulated time.
 *
 * @param team name of the robot's team
 * @param number the robot's shirt number, 1 to 11
 * @param seconds simulated time in seconds, taken from the robot's last perceptor message, which identifies the cycle
 * @param item the item
 */
public record TelemetryMessage(String team, int number, double seconds, TelemetryItem item) {}
