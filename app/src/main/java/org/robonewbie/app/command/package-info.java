/**
 * The commands of the program, one class {@code …Command} each. Read {@link org.robonewbie.app.command.RoboNewbieCommand} first.
 *
 * <p><strong>Internal</strong>: not part of the API; may change in any version.
 */
@org.jspecify.annotations.NullMarked
package org.robonewbie.app.command;
