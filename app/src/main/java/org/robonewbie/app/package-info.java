/**
 * The command line: one program that shows, runs and checks everything. Start in {@link org.robonewbie.app.Main}; each
 * command is one class {@code …Command}.
 */
@org.jspecify.annotations.NullMarked
package org.robonewbie.app;
