/**
 * Finds, compiles and starts the programs that students write. Read {@link org.robonewbie.programs.ProgramFinder} first.
 *
 * <p><strong>Internal</strong>: no part of the API, may change with every version.
 */
@org.jspecify.annotations.NullMarked
package org.robonewbie.programs;
