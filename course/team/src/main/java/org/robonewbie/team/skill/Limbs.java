package org.robonewbie.team.skill;

import org.robonewbie.agent.Robot;
import org.robonewbie.agent.motion.LookAround;
import org.robonewbie.agent.motion.Motions;
import org.robonewbie.agent.walk.Walk;

/**
 * All that a skill moves.
 *
 * @param nao sensors and motors
 * @param walk the walk into any direction
 * @param motions motions by name
 * @param head the movement of the head to see more
 */
public record Limbs(Robot nao, Walk walk, Motions motions, LookAround head) {}
