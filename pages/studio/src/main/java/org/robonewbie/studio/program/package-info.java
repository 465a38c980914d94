/**
 * The program editor of the studio: pages edit programs, show diagnostics while the user types, and run them on the pitch. Start with
 * {@link org.robonewbie.studio.program.CompilerService}.
 *
 * <p><strong>Internal</strong>: not part of the API; may change in any version.
 */
@org.jspecify.annotations.NullMarked
package org.robonewbie.studio.program;
