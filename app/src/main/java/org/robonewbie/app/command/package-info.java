/** The commands of the program, one class {@code …Command} each. Read {@link org.robonewbie.app.command.RoboNewbieCommand} first. */
@org.jspecify.annotations.NullMarked
package org.robonewbie.app.command;
