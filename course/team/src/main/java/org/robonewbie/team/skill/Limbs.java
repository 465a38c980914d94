package org.robonewbie.team.skill;

import org.robonewbie.agent.Robot;
import org.robonewbie.agent.motion.LookAround;
import org.robonewbie.agent.motion.Motions;
import org.robonewbie.agent.walk.Walk;

/**
 * Access to the robot for skills: its sensors, motors and motions.
 *
 * @param nao sensors and motors
 * @param walk the omnidirectional walk
 * @param motions keyframe motions
 * @param head the head scan
 */
public record Limbs(Robot nao, Walk walk, Motions motions, LookAround head) {}
