/**
 * What to do about the compiler's remarks, for the compiler of this computer and for that in a page alike. Nothing here knows files, and
 * of the rest of RoboNewbie only how to find misspelt words. Read {@link org.robonewbie.programs.hint.Hints} first.
 *
 * <p><strong>Internal</strong>: no part of the API, may change with every version.
 */
@org.jspecify.annotations.NullMarked
package org.robonewbie.programs.hint;
