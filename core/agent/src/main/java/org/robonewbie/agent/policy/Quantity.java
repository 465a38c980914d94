package org.robonewbie.agent.policy;

/**
 * An input or output of a policy.
 *
 * @param name name of the quantity, such as {@code gyro.forward}
 * @param unit unit of measurement, such as {@code degrees/s}, optionally with a factor, as in {@code 10 degrees}; {@code 1} if
 *     dimensionless
 */
public record Quantity(String name, String unit) {}
