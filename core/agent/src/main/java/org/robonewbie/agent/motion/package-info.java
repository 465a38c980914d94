/**
 * How the robot moves: motors with speeds and targets, motions from text files, and the head that looks around. Read
 * {@link org.robonewbie.agent.motion.Motions} first.
 */
@org.jspecify.annotations.NullMarked
package org.robonewbie.agent.motion;
