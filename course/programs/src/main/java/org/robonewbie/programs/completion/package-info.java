/**
 * Code completion with documentation, shared by the compiler on this computer and the one in the browser. The package depends
 * neither on files nor on the rest of RoboNewbie. Start with {@link org.robonewbie.programs.completion.Completion}.
 *
 * <p><strong>Internal</strong>: not part of the API; may change in any version.
 */
@org.jspecify.annotations.NullMarked
package org.robonewbie.programs.completion;
