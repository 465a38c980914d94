/**
 * What could be written at a place of a program, and the documentation of it, for the compiler of this computer and for that in a page
 * alike. Nothing here knows files or the rest of RoboNewbie. Read {@link org.robonewbie.programs.completion.Completion} first.
 *
 * <p><strong>Internal</strong>: no part of the API, may change with every version.
 */
@org.jspecify.annotations.NullMarked
package org.robonewbie.programs.completion;
