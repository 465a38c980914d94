package org.robonewbie.agent.policy;

/**
 * A number that a policy takes or gives.
 *
 * @param name such as {@code gyro.forward}
 * @param unit such as {@code degrees/s}, or {@code 10 degrees} if the number is the multiple of that; {@code 1} for a mere number
 */
public record Quantity(String name, String unit) {}
