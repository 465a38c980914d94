/**
 * Output of a robot for its programmer: the log, and reports of program errors with line numbers. Read
 * {@link org.robonewbie.agent.log.Logger} first.
 */
@org.jspecify.annotations.NullMarked
package org.robonewbie.agent.log;
