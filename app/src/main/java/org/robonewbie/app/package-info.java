/**
 * The command line: one program that shows, runs and checks everything. Start in {@link org.robonewbie.app.Main}; its commands are in
 * {@code command}, what finds and starts the programs of students in {@code program}.
 *
 * <p><strong>Internal</strong>: no part of the API, may change with every version.
 */
@org.jspecify.annotations.NullMarked
package org.robonewbie.app;
