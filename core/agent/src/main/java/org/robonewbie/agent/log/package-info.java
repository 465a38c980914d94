/**
 * What a robot tells its programmer: the log, and mistakes with the line where they were made. Read {@link
 * org.robonewbie.agent.log.Logger} first.
 */
@org.jspecify.annotations.NullMarked
package org.robonewbie.agent.log;
