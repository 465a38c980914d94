package org.robonewbie.simulator;

/**
 * What simulator and agent have said to each other in one cycle, as it goes over the wire, without length prefixes.
 *
 * @param robot number of the robot's connection, as in {@link RobotSnapshot#id}
 * @param cycle number of the cycle since the start, as in {@link WorldSnapshot#cycle}
 * @param perceptors the message that tells the robot's senses at the end of the cycle
 * @param effectors what the agent had sent and was carried out in the cycle; empty if it sent nothing
 */
public record AgentMessages(int robot, long cycle, String perceptors, String effectors) {}
