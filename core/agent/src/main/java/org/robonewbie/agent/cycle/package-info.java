/**
 * The cycle of a robot: a perceptor message comes in, a list of commands goes out. Nothing here needs a thread, a clock, a socket or a
 * file. Read {@link org.robonewbie.agent.cycle.RobotRuntime} first.
 *
 * <p><strong>Internal</strong>: not part of the API; may change in any version.
 */
@org.jspecify.annotations.NullMarked
package org.robonewbie.agent.cycle;
