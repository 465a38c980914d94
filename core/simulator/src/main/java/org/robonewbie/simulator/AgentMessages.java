package org.robonewbie.simulator;

/**
 * The messages that the simulator and an agent exchanged in one cycle, in wire format without length prefixes.
 *
 * @param robot id of the robot's connection, as in {@link RobotSnapshot#id}
 * @param cycle number of the cycle since the start, as in {@link WorldSnapshot#cycle}
 * @param perceptors the perceptor message generated at the end of the cycle
 * @param effectors the effector messages executed in the cycle; empty if the agent sent none
 */
public record AgentMessages(int robot, long cycle, String perceptors, String effectors) {}
