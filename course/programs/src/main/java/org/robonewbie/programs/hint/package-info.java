/**
 * Advice for compiler diagnostics, shared by the compiler on this computer and the one in the browser. The package depends
 * neither on files nor on the rest of RoboNewbie, except for the spelling correction. Start with {@link
 * org.robonewbie.programs.hint.Hints}.
 *
 * <p><strong>Internal</strong>: not part of the API; may change in any version.
 */
@org.jspecify.annotations.NullMarked
package org.robonewbie.programs.hint;
