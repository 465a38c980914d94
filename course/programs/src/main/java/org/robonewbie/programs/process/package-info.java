/**
 * Programs in processes of their own: with limits, in a {@link org.robonewbie.programs.process.Sandbox} where there is one. Read {@link
 * org.robonewbie.programs.process.ChildProcess} first, which all of them are, then {@link
 * org.robonewbie.programs.process.ProgramMain}, with which they begin.
 *
 * <p><strong>Internal</strong>: no part of the API, may change with every version.
 */
@org.jspecify.annotations.NullMarked
package org.robonewbie.programs.process;
